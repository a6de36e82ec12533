#include "geometry/predicates/distance.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "geometry/predicates/segment_box.hpp"
#include "tests/geometry/unit_and_infinity.hpp"
#include "tests/kit/geometry/adversary.hpp"
#include "tests/kit/geometry/exact_oracle.hpp"
#include "tests/kit/scaled.hpp"

namespace asv::geometry {
namespace {

using test::Adversary;

double largest_difference(const Segment& segment, const Box& box) {
    const Box all = bounds(segment);
    return std::max(std::max(all.high.x, box.high.x) - std::min(all.low.x, box.low.x),
                    std::max(all.high.y, box.high.y) - std::min(all.low.y, box.low.y));
}

TEST(Distance, PointToBox) {
    EXPECT_EQ(distance(Point{0.5, 0.5}, unit), 0);
    EXPECT_EQ(distance(Point{1, 1}, unit), 0);
    EXPECT_EQ(distance(Point{3, 0.5}, unit), 2);
    EXPECT_EQ(distance(Point{-3, 5}, unit), 5);
    EXPECT_GT(distance(Point{std::nextafter(1.0, 2.0), 0.5}, unit), 0);
    EXPECT_GT(distance(Point{-4e-324, -4e-324}, unit), 0);
}

TEST(Distance, SegmentToBox) {
    EXPECT_EQ(distance(Segment{{-1, 0.5}, {2, 0.5}}, unit), 0);
    EXPECT_EQ(distance(Segment{{0, 3}, {1, 2}}, unit), 1);
    EXPECT_DOUBLE_EQ(distance(Segment{{0, 3}, {3, 0}}, unit), std::sqrt(0.5));
    EXPECT_EQ(distance(Segment{{4, 5}, {4, 5}}, unit), 5);
}

TEST(Distance, ZeroExactlyWhenTheyMeet) {
    constexpr std::uint64_t seed = 11;
    Adversary draw(seed);
    for (std::size_t i = 0; i < test::scaled(300'000); ++i) {
        const auto [segment, box] = draw.pair();
        ASSERT_EQ(distance(segment, box) == 0, test::exact_meets(segment, box))
            << "seed " << seed << ", case " << i;
        ASSERT_EQ(distance(segment.a, box) == 0, contains(box, segment.a))
            << "seed " << seed << ", case " << i;
    }
}

TEST(Distance, KeepsTheStatedError) {
    constexpr std::uint64_t seed = 12;
    Adversary draw(seed);
    for (std::size_t i = 0; i < test::scaled(50'000); ++i) {
        const auto [segment, box] = draw.pair();
        const double size = largest_difference(segment, box);
        if (size < 1e-150 || size > 1e150) continue;
        ASSERT_NEAR(distance(segment, box), std::sqrt(test::exact_squared_distance(segment, box)),
                    4e-15 * size)
            << "seed " << seed << ", case " << i;
    }
}

}  // namespace
}  // namespace asv::geometry
