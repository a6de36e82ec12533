#include "io/drawing/scene/box_union.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/kit/geometry/random_boxes.hpp"

namespace asv::io {
namespace {

using geometry::Box;
using geometry::Point;
using geometry::Segment;

double total_length(const std::vector<Segment>& segments) {
    double sum = 0;
    for (const Segment& s : segments) sum += std::abs(s.b.x - s.a.x) + std::abs(s.b.y - s.a.y);
    return sum;
}

bool covered(const std::vector<Box>& boxes, double x, double y) {
    return std::any_of(boxes.begin(), boxes.end(), [&](const Box& box) {
        return geometry::contains(box, {x, y});
    });
}

/// The border of the union of boxes with whole coordinates from 0 to 12, cell by cell.
double border_by_cells(const std::vector<Box>& boxes) {
    const auto full = [&](int x, int y) { return covered(boxes, x + 0.5, y + 0.5); };
    double length = 0;
    for (int x = -1; x <= 12; ++x) {
        for (int y = -1; y <= 12; ++y) {
            if (full(x, y) != full(x + 1, y)) ++length;
            if (full(x, y) != full(x, y + 1)) ++length;
        }
    }
    return length;
}

TEST(UnionSides, OfOneBoxAreItsFourSides) {
    const UnionSides sides = union_sides(std::vector<Box>{{{0, 0}, {2, 1}}});
    EXPECT_EQ(sides.outline.size(), 4U);
    EXPECT_EQ(total_length(sides.outline), 6);
    EXPECT_TRUE(sides.seams.empty());
}

TEST(UnionSides, TwoBoxesSideBySideHaveASeam) {
    const UnionSides sides = union_sides(std::vector<Box>{{{0, 0}, {1, 1}}, {{1, 0.25}, {2, 1}}});
    ASSERT_EQ(sides.seams.size(), 1U);
    EXPECT_EQ(sides.seams[0], (Segment{{1, 0.25}, {1, 1}}));
    EXPECT_EQ(total_length(sides.outline), 6);
}

TEST(UnionSides, BoxesThatTouchAtACornerKeepAllTheirSides) {
    const UnionSides sides = union_sides(std::vector<Box>{{{0, 0}, {1, 1}}, {{1, 1}, {2, 2}}});
    EXPECT_EQ(total_length(sides.outline), 8);
    EXPECT_EQ(total_length(sides.seams), 0);
}

TEST(UnionSides, ABoxTwiceAndABoxInsideChangeNothing) {
    const std::vector<Box> boxes{
        {{0, 0}, {4, 4}}, {{0, 0}, {4, 4}}, {{1, 1}, {2, 2}}, {{3, 1}, {4, 2}}};
    EXPECT_EQ(total_length(union_sides(boxes).outline), 16);
}

TEST(UnionSides, AreTheBorderOfRandomUnions) {
    for (unsigned seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        test::Random random(seed);
        const auto whole = [&](double high) { return std::floor(random.uniform(0, high)); };
        std::vector<Box> boxes;
        for (unsigned i = 0; i < 1 + seed % 40; ++i) {
            const Point low{whole(9), whole(9)};
            boxes.push_back({low, {low.x + 1 + whole(3), low.y + 1 + whole(3)}});
        }
        const UnionSides sides = union_sides(boxes);
        ASSERT_EQ(total_length(sides.outline), border_by_cells(boxes));
        for (const Segment& s : sides.seams) {
            const Point middle{(s.a.x + s.b.x) / 2, (s.a.y + s.b.y) / 2};
            ASSERT_TRUE(covered(boxes, middle.x, middle.y));
        }
    }
}

}  // namespace
}  // namespace asv::io
