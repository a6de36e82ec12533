#include "io/drawing/path_profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "geometry/predicates/distance.hpp"
#include "io/drawing/drawing.hpp"
#include "tests/kit/files/drawing_samples.hpp"
#include "tests/kit/geometry/random_boxes.hpp"

namespace asv::io {
namespace {

using geometry::Segment;
using test::Box;
using test::Point;
using test::sample;
using test::wide_arc;

TEST(PathProfile, AgreesWithBruteForceOnRandomPaths) {
    for (unsigned seed = 1; seed <= 30; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        test::Random random(seed);
        const auto in_square = [&] { return random.uniform(0, 1); };
        core::Problem problem;
        problem.obstacles = test::random_boxes(random, 60, 0.1);
        // Steps of all sizes, so that some stay within reach of the last full look and some do not.
        core::Path path(4);
        std::vector<Point> state = wide_arc(4, {0.5, 0.5});
        for (int i = 0; i < 80; ++i) {
            path.push_back(state);
            const double size = std::pow(10, -3 * in_square());
            for (Point& point : state) {
                point.x += size * (in_square() - 0.5) / 4;
                point.y += size * (in_square() - 0.5) / 4;
            }
        }
        const std::vector<StateMeasures> measures = measure(problem, path);
        ASSERT_EQ(measures.size(), path.size());
        for (std::size_t i = 0; i < path.size(); ++i) {
            double least = std::numeric_limits<double>::infinity();
            for (std::size_t broom = 0; broom < 3; ++broom) {
                for (const Box& box : problem.obstacles) {
                    least =
                        std::min(least, geometry::distance(broom_of(path.state(i), broom), box));
                }
            }
            ASSERT_EQ(measures[i].clearance->distance, least) << "state " << i;
            const Segment broom = broom_of(path.state(i), measures[i].clearance->broom);
            ASSERT_EQ(geometry::distance(broom, problem.obstacles[measures[i].clearance->obstacle]),
                      least);
        }
    }
}

TEST(PathProfile, TheShortestLinkIsAsLongAsTheDistance) {
    test::Random random(7);
    const auto in_square = [&] { return random.uniform(0, 1); };
    for (int i = 0; i < 20000; ++i) {
        const auto point = [&] { return Point{in_square(), in_square()}; };
        const Segment segment{point(), point()};
        const Point a = point();
        const Point b = point();
        const Box box{{std::min(a.x, b.x), std::min(a.y, b.y)},
                      {std::max(a.x, b.x), std::max(a.y, b.y)}};
        const Segment link = shortest_link(segment, box);
        const double length = std::hypot(link.b.x - link.a.x, link.b.y - link.a.y);
        ASSERT_NEAR(length, geometry::distance(segment, box), 1e-12) << "case " << i;
        ASSERT_LT(geometry::distance(link.b, box), 1e-12);
        ASSERT_LT(geometry::distance(Segment{link.a, link.a}, Box{link.a, link.a}), 1e-12);
    }
}

TEST(PathProfile, MeasuresCostAreaAndTurns) {
    core::Problem problem;
    core::Path path(3);
    const std::vector<Point> right_angle{{0, 0}, {0.3, 0}, {0.3, 0.4}};
    std::vector<Point> moved = right_angle;
    for (Point& point : moved) point.x += 0.01;
    path.push_back(right_angle);
    path.push_back(moved);
    const auto measures = measure(problem, path);
    EXPECT_EQ(measures[0].cost, 0);
    EXPECT_NEAR(measures[1].cost, 0.03, 1e-15);
    EXPECT_NEAR(measures[0].area, 0.06, 1e-15);
    ASSERT_TRUE(measures[0].tightest_turn);
    EXPECT_NEAR(*measures[0].tightest_turn, std::acos(-0.8), 1e-12) << "at the sharpest corner";
    EXPECT_EQ(measures[0].tightest_asv, 2U);
    EXPECT_FALSE(measures[0].clearance) << "there are no obstacles";
}

TEST(PathProfile, TakesFewerThanThreeAsvs) {
    const std::vector<Box> two_walls{{{0.4, 0}, {0.5, 0.2}}, {{0.4, 0.45}, {0.5, 1}}};
    for (std::size_t n = 1; n <= 2; ++n) {
        const Exhibit exhibit = make_exhibit(sample(n, {{0.1, 0.3}, {0.3, 0.3}}, two_walls));
        EXPECT_FALSE(exhibit.measures[0].tightest_turn);
        EXPECT_EQ(exhibit.measures[0].area, 0);
        EXPECT_NEAR(exhibit.measures.back().clearance->distance,
                    n == 1 ? std::hypot(0.1, 0.1) : std::hypot(0.05, 0.1), 1e-9);
        EXPECT_FALSE(draw_picture(exhibit, PictureFormat::svg, Theme::light).empty());
    }
}

}  // namespace
}  // namespace asv::io
