#include "geometry/predicates/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/kit/geometry/adversary.hpp"
#include "tests/kit/scaled.hpp"

namespace asv::geometry {
namespace {

using test::Adversary;
using Polygon = std::vector<Point>;

/// n points round the unit circle, winding the given number of times.
Polygon star(int n, int windings) {
    Polygon polygon;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * windings * i / n;
        polygon.push_back({std::cos(angle), std::sin(angle)});
    }
    return polygon;
}

/// The answer must not depend on where the walk starts, and its sign turns with the walk.
void expect_convexity(const Polygon& polygon, int expected) {
    Polygon walk = polygon;
    for (std::size_t i = 0; i < walk.size(); ++i) {
        EXPECT_EQ(convex_orientation(walk), expected);
        const Polygon back(walk.rbegin(), walk.rend());
        EXPECT_EQ(convex_orientation(back), -expected);
        std::rotate(walk.begin(), walk.begin() + 1, walk.end());
    }
}

TEST(SignedArea, KnownPolygons) {
    EXPECT_EQ(signed_area(Polygon{{0, 0}, {2, 0}, {2, 3}, {0, 3}}), 6);
    EXPECT_EQ(signed_area(Polygon{{0, 0}, {0, 3}, {2, 3}, {2, 0}}), -6);
    EXPECT_EQ(signed_area(Polygon{{0, 0}, {2, 0}}), 0);
    EXPECT_EQ(signed_area(Polygon{}), 0);
}

TEST(ConvexOrientation, ConvexPolygons) {
    for (int n = 3; n < 12; ++n) expect_convexity(star(n, 1), 1);
    expect_convexity({{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}, 1);
    expect_convexity({{0, 0}, {0, 0}, {2, 0}, {2, 2}, {2, 2}, {2, 2}, {0, 2}, {0, 0}}, 1);
}

TEST(ConvexOrientation, ReflexVertex) {
    expect_convexity({{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}, 0);
    const double inside = std::nextafter(1.0, 0.0);
    expect_convexity({{0, 1}, {1, inside}, {2, 1}, {1, 3}}, 1);
    expect_convexity({{0, inside}, {1, 1}, {2, inside}, {1, 3}}, 0);
}

TEST(ConvexOrientation, SeveralWindings) {
    for (int windings = 2; windings < 5; ++windings) {
        expect_convexity(star(2 * windings + 1, windings), 0);
        expect_convexity(star(4 * windings + 1, windings), 0);
    }
    Polygon twice = star(5, 1);
    twice.insert(twice.end(), twice.begin(), twice.end());
    expect_convexity(twice, 0);
}

TEST(ConvexOrientation, ReversalsAndDegenerateInput) {
    expect_convexity({{0, 0}, {1, 0}, {2, 0}}, 0);
    expect_convexity({{0, 0}, {0, 2}, {0, 1}}, 0);
    expect_convexity({{1, 1}, {1, 1}, {1, 1}}, 0);
    expect_convexity({{0, 0}, {3, 0}, {2, 0}, {2, 2}, {0, 2}}, 0);
    EXPECT_EQ(convex_orientation(Polygon{}), 0);
}

// Midpoints of dyadic coordinates are exact, so they are straight vertices and change nothing.
TEST(ConvexOrientation, StraightVerticesChangeNothing) {
    constexpr std::uint64_t seed = 5;
    Adversary draw(seed);
    for (std::size_t i = 0; i < test::scaled(20'000); ++i) {
        Polygon polygon;
        for (int k = 3 + draw.pick(3); k > 0; --k) {
            polygon.push_back({draw.pick(8) * 0.25, draw.pick(8) * 0.25});
        }
        const int expected = convex_orientation(polygon);
        const auto at = static_cast<std::size_t>(draw.pick(static_cast<int>(polygon.size())));
        const Point p = polygon[at];
        const Point q = polygon[(at + 1) % polygon.size()];
        polygon.insert(polygon.begin() + static_cast<std::ptrdiff_t>(at) + 1,
                       {(p.x + q.x) / 2, (p.y + q.y) / 2});
        ASSERT_EQ(convex_orientation(polygon), expected) << "seed " << seed << ", case " << i;
    }
}

}  // namespace
}  // namespace asv::geometry
