#include "core/space/sampling/corridors.hpp"

#include <algorithm>
#include <vector>

#include "core/model/problem.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using test::for_seeds;

constexpr Box unit{{0, 0}, {1, 1}};

TEST(Corridors, FindsTheGapsBetweenBoxesThatFaceEachOther) {
    const std::vector<Box> boxes{{{0.3, 0.3}, {0.6, 0.5}}, {{0.4, 0.55}, {0.8, 0.7}}};
    const Corridors corridors(boxes, unit, 0.1);
    ASSERT_EQ(corridors.gaps().size(), 1U);
    EXPECT_EQ(corridors.gaps()[0], (Box{{0.4, 0.5}, {0.6, 0.55}}));
    for_seeds(100, [&](Rng& rng) {
        const auto point = corridors.sample(rng);
        ASSERT_TRUE(point);
        ASSERT_TRUE(geometry::contains(corridors.gaps()[0], *point));
    });
}

TEST(Corridors, ABoxAndTheBoundsFaceEachOtherAsWell) {
    const std::vector<Box> boxes{{{0.05, 0.4}, {0.5, 0.95}}};
    const Corridors corridors(boxes, unit, 0.1);
    const std::vector<Box> expected{{{0, 0.4}, {0.05, 0.95}}, {{0.05, 0.95}, {0.5, 1}}};
    ASSERT_EQ(corridors.gaps().size(), 2U);
    for (const Box& gap : expected)
        EXPECT_EQ(std::count(corridors.gaps().begin(), corridors.gaps().end(), gap), 1);
}

TEST(Corridors, WideGapsAndOverlapsAreNone) {
    Rng rng(1);
    EXPECT_FALSE(Corridors({}, unit, 0.5).sample(rng));
    const std::vector<Box> far{{{0.3, 0.2}, {0.6, 0.4}}, {{0.3, 0.6}, {0.6, 0.8}}};
    EXPECT_TRUE(Corridors(far, unit, 0.19).gaps().empty());
    EXPECT_FALSE(Corridors(far, unit, 0.21).gaps().empty());
    const std::vector<Box> overlapping{{{0.3, 0.3}, {0.6, 0.6}}, {{0.5, 0.5}, {0.7, 0.7}}};
    EXPECT_TRUE(Corridors(overlapping, unit, 0.1).gaps().empty());
}

}  // namespace
}  // namespace asv::core
