#include "geometry/predicates/segment_box.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/geometry/unit_and_infinity.hpp"
#include "tests/kit/geometry/adversary.hpp"
#include "tests/kit/geometry/exact_oracle.hpp"
#include "tests/kit/scaled.hpp"

namespace asv::geometry {
namespace {

using test::Adversary;

TEST(SegmentBox, TouchingCounts) {
    EXPECT_TRUE(meets({{-1, 1}, {2, 1}}, unit));
    EXPECT_TRUE(meets({{1, 1}, {2, 3}}, unit));
    EXPECT_TRUE(meets({{0, 2}, {2, 0}}, unit)) << "touches the corner (1, 1) from outside";
    EXPECT_TRUE(meets({{0.2, 0.2}, {0.3, 0.3}}, unit));
    EXPECT_TRUE(meets({{0.5, -1}, {0.5, 2}}, unit));
}

TEST(SegmentBox, ApartByOneUlp) {
    const double above = std::nextafter(1.0, 2.0);
    EXPECT_FALSE(meets({{-1, above}, {2, above}}, unit));
    EXPECT_FALSE(meets({{0, std::nextafter(2.0, 3.0)}, {2, 0}}, unit));
}

TEST(SegmentBox, EmptyBoxMeetsNothing) {
    EXPECT_FALSE(meets({{-1, 0.5}, {2, 0.5}}, {{0.6, 0}, {0.4, 1}}));
    EXPECT_FALSE(meets({{0.5, 0.5}, {0.5, 0.5}}, {{0, 0.6}, {1, 0.4}}));
}

TEST(SegmentBox, AgreesWithExactKernel) {
    constexpr std::uint64_t seed = 7;
    Adversary draw(seed);
    std::size_t meeting = 0;
    const std::size_t count = test::scaled(1'000'000);
    for (std::size_t i = 0; i < count; ++i) {
        const auto [segment, box] = draw.pair();
        const bool expected = test::exact_meets(segment, box);
        if (expected) ++meeting;
        ASSERT_EQ(meets(segment, box), expected) << "seed " << seed << ", case " << i;
        ASSERT_EQ(meets({segment.b, segment.a}, box), expected)
            << "seed " << seed << ", case " << i << " reversed";
    }
    EXPECT_GT(meeting, count / 5);
    EXPECT_LT(meeting, count - count / 5);
}

}  // namespace
}  // namespace asv::geometry
