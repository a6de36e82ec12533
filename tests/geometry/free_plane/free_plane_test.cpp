#include "geometry/free_plane/free_plane.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/geometry/unit_and_infinity.hpp"
#include "tests/kit/geometry/visibility_oracle.hpp"

/// Scenes by hand, of one box to a spiral.

namespace asv::geometry {
namespace {

double shortest(const std::vector<Box>& boxes, const Point& from, const Point& to) {
    return FreePlane(boxes, unit).shortest_path(from, to);
}

TEST(FreePlane, StraightWhereNothingIsInTheWay) {
    EXPECT_DOUBLE_EQ(shortest({}, {0.1, 0.1}, {0.4, 0.5}), 0.5);
    EXPECT_DOUBLE_EQ(shortest({{{0.6, 0.6}, {0.7, 0.7}}}, {0.1, 0.1}, {0.4, 0.5}), 0.5);
    EXPECT_EQ(shortest({}, {0.3, 0.3}, {0.3, 0.3}), 0);
}

TEST(FreePlane, RoundABox) {
    const std::vector<Box> boxes{{{0.4, 0.2}, {0.6, 0.6}}};
    const double over = 2 * std::hypot(0.2, 0.1) + 0.2;
    EXPECT_NEAR(shortest(boxes, {0.2, 0.5}, {0.8, 0.5}), over, 1e-15);
    EXPECT_NEAR(shortest(boxes, {0.4, 0.5}, {0.6, 0.5}), 0.4, 1e-15) << "starts on the wall";
}

TEST(FreePlane, ThePathHasTheLengthAndBendsAtCorners) {
    const std::vector<Box> boxes{{{0.3, 0.0}, {0.35, 0.8}}, {{0.6, 0.2}, {0.65, 1.0}}};
    FreePlane space(boxes, unit);
    const Point from{0.1, 0.1}, to{0.9, 0.9};
    const auto points = space.shortest_path_points(from, to, 1000);
    const std::vector<Point> expected{from, {0.3, 0.8}, {0.35, 0.8}, {0.6, 0.2}, {0.65, 0.2}, to};
    EXPECT_EQ(points, expected);
    double length = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
        length += std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y);
    EXPECT_NEAR(length, space.shortest_path(from, to), 1e-15);
    EXPECT_TRUE(space.shortest_path_points(from, to, 0).empty()) << "too much to look at";
    EXPECT_TRUE(space.shortest_path_points(from, {0.32, 0.5}, 1000).empty()) << "in a box";
}

TEST(FreePlane, AlongWallsIsAllowed) {
    const std::vector<Box> boxes{{{0.2, 0.0}, {0.4, 0.5}}, {{0.6, 0.0}, {0.8, 0.5}}};
    EXPECT_DOUBLE_EQ(shortest(boxes, {0.1, 0.5}, {0.9, 0.5}), 0.8);
    const std::vector<Box> zigzag{{{0.2, 0.1}, {0.4, 0.5}}, {{0.6, 0.5}, {0.8, 0.9}}};
    EXPECT_DOUBLE_EQ(shortest(zigzag, {0.1, 0.5}, {0.9, 0.5}), 0.8) << "a wall on either side";
}

TEST(FreePlane, BoxesThatTouchAreSealed) {
    const std::vector<Box> side{{{0.3, 0.2}, {0.5, 0.7}}, {{0.5, 0.2}, {0.7, 0.7}}};
    EXPECT_NEAR(shortest(side, {0.5, 0.1}, {0.5, 0.8}), 2 * std::hypot(0.2, 0.1) + 0.5, 1e-15);
    const std::vector<Box> corner{{{0, 0.2}, {0.5, 0.4}}, {{0.5, 0.4}, {1, 0.6}}};
    EXPECT_EQ(shortest(corner, {0.1, 0.1}, {0.9, 0.9}), infinity);
    const std::vector<Box> border{{{0.3, 0.0}, {0.5, 0.7}}};
    EXPECT_NEAR(shortest(border, {0.2, 0.0}, {0.6, 0.0}), 2 * std::hypot(0.1, 0.7) + 0.2, 1e-15);
}

TEST(FreePlane, TheSmallestGapIsOpen) {
    const double beside = std::nextafter(0.5, 1.0);
    const std::vector<Box> boxes{{{0, 0.4}, {0.5, 0.6}}, {{beside, 0.4}, {1, 0.6}}};
    EXPECT_DOUBLE_EQ(shortest(boxes, {0.5, 0.1}, {0.5, 0.9}), 0.8);
}

TEST(FreePlane, CoveredPointsAreNotConnected) {
    FreePlane space(std::vector<Box>{{{0.4, 0.4}, {0.6, 0.6}}}, unit);
    EXPECT_FALSE(space.is_free({0.5, 0.5}));
    EXPECT_TRUE(space.is_free({0.4, 0.5}));
    EXPECT_FALSE(space.is_free({1.1, 0.5}));
    EXPECT_FALSE(space.connected({0.5, 0.5}, {0.1, 0.1}));
    EXPECT_EQ(space.shortest_path({0.5, 0.5}, {0.5, 0.5}), infinity);
    EXPECT_EQ(space.shortest_path({0.1, 0.1}, {1.1, 0.5}), infinity);
}

TEST(FreePlane, BoxesWithoutInteriorAreIgnored) {
    const std::vector<Box> boxes{
        {{0.5, 0.0}, {0.5, 1.0}}, {{0.7, 0.0}, {0.6, 1.0}}, {{0.3, 0.3}, {0.3, 0.3}}};
    EXPECT_DOUBLE_EQ(shortest(boxes, {0.1, 0.5}, {0.9, 0.5}), 0.8);
}

/// A square spiral of touching walls 0.1 thick, its way 0.1 wide.
std::vector<Box> spiral() {
    return {{{0.0, 0.1}, {0.9, 0.2}}, {{0.8, 0.2}, {0.9, 0.9}}, {{0.1, 0.8}, {0.8, 0.9}},
            {{0.1, 0.3}, {0.2, 0.8}}, {{0.2, 0.3}, {0.7, 0.4}}, {{0.6, 0.4}, {0.7, 0.7}},
            {{0.3, 0.6}, {0.6, 0.7}}};
}

TEST(FreePlane, FollowsASpiral) {
    const std::vector<Box> boxes = spiral();
    const double expected =
        test::brute_force_shortest_path(boxes, unit, {0.05, 0.05}, {0.45, 0.5}, 1e-9);
    EXPECT_GT(expected, 4);
    EXPECT_NEAR(shortest(boxes, {0.05, 0.05}, {0.45, 0.5}), expected, 1e-7);
}

}  // namespace
}  // namespace asv::geometry
