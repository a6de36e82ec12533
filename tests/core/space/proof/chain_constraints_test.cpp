#include "core/space/proof/chain_constraints.hpp"

#include <cmath>
#include <numbers>

#include "core/solve/planning_frame.hpp"
#include "core/solve/solve.hpp"
#include "core/space/chain_world.hpp"
#include "geometry/predicates/polygon.hpp"
#include "tests/kit/chains/configurations.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using test::arc;
using test::for_seeds;
using test::moved;
using test::Points;
using test::ring;
using test::Row;

TEST(ChainConstraints, MeasuresOfAPose) {
    for_seeds(200, [](Rng& rng) {
        const std::size_t n = 3 + rng.below(10);
        const Chain chain(n, 0.05, Anchor::first_asv);
        Row row(chain.dimension());
        for (double& value : row) value = rng.uniform(-1, 1);
        Pose pose = chain.make_pose();
        chain.forward(row, pose);
        const Points p = test::positions_of(chain, row);
        const double closing = std::hypot(p[0].x - p[n - 1].x, p[0].y - p[n - 1].y);
        const double side = std::atan2(p[0].y - p[n - 1].y, p[0].x - p[n - 1].x);
        EXPECT_NEAR(area(pose), geometry::signed_area(p), 1e-14);
        EXPECT_NEAR(closing_side(pose), closing, 1e-14);
        EXPECT_NEAR(last_closing_turn(pose), closing * std::sin(side - pose.heading.back()), 1e-13);
        EXPECT_NEAR(first_closing_turn(pose), closing * std::sin(pose.heading.front() - side),
                    1e-13);
    });
}

TEST(ChainConstraints, EndsWithRoomLeaveTheFullMargins) {
    const Problem problem =
        test::problem(ring(7, {0.3, 0.3}, 0), ring(7, {0.7, 0.7}, 1), {{{0.45, 0.45}, {0.5, 0.5}}});
    const Chain chain(7, 0.05, Anchor::centroid);
    const Margins margins;
    const ChainConstraints limits = make_constraints(problem, chain);
    EXPECT_EQ(limits.obstacles.at(0), geometry::grown(problem.obstacles[0], margins.length));
    EXPECT_EQ(limits.bounds, geometry::grown({{0, 0}, {1, 1}}, -margins.length));
    const double least = problem.requirements.min_area(7);
    EXPECT_DOUBLE_EQ(limits.min_area, least * (1 + margins.relative_area));
    EXPECT_DOUBLE_EQ(limits.min_closing_side, margins.closing_side);
    for (const double turn : limits.min_turn) EXPECT_EQ(turn, 0);
}

TEST(ChainConstraints, ATightEndLeavesNoMoreMarginThanItHas) {
    // A right angle whose lowest broom lies on y = 0.5.
    const Points low = arc(3, {0.3, 0.5}, 0, std::numbers::pi / 2);
    const Points high = moved(low, 0.2, 0.2);
    for (const double gap : {-9e-6, -1e-9, 0.0, 1e-9, 4e-6}) {
        const Box below{{0.2, 0.3}, {0.8, 0.5 - gap}};
        const Chain chain(3, 0.05, Anchor::first_asv);
        for (const Problem& problem :
             {test::problem(low, high, {below}), test::problem(high, low, {below})}) {
            const ChainConstraints limits = make_constraints(problem, chain);
            EXPECT_NEAR(limits.obstacles.at(0).high.y, 0.5, 2e-11) << gap;
            EXPECT_LT(limits.obstacles.at(0).high.y, 0.5) << gap;
        }
    }
}

TEST(ChainConstraints, ObstaclesThinnerThanTheToleranceVanish) {
    const Problem problem =
        test::problem(ring(3, {0.3, 0.3}, 0), ring(3, {0.7, 0.7}, 0),
                      {{{0.1, 0.5}, {0.9, 0.5 + 1.9e-5}}, {{0.1, 0.5}, {0.9, 0.5 + 2.1e-5}}});
    EXPECT_EQ(make_constraints(problem, {3, 0.05, Anchor::centroid}).obstacles.size(), 1U);
}

/// Six ASVs on a triangle with sides of two brooms: straight joints and a straight closing turn.
Points triangle(Point at, double heading) {
    constexpr double third = 2 * std::numbers::pi / 3;
    Points points{at};
    for (const double turn : {0.0, third, 0.0, third, 0.0}) {
        heading += turn;
        points.push_back({points.back().x + 0.05 * std::cos(heading),
                          points.back().y + 0.05 * std::sin(heading)});
    }
    return points;
}

/// A chain that touches a box, or nearly so, or dips into it by less than the tolerance; in part a
/// shape on the boundary of what is allowed; positions rounded as in a file.
Problem tight_problem(Rng& rng) {
    const std::size_t sizes[] = {1, 3, 6, 7, 15};
    const std::size_t n = sizes[rng.below(5)];
    const double digits = rng.chance(0.5) ? 1e6 : 1e12;
    const auto rounded = [&](Points points) {
        for (Point& p : points)
            p = {std::round(p.x * digits) / digits, std::round(p.y * digits) / digits};
        return points;
    };
    const double quarter = std::numbers::pi / 2 * static_cast<double>(rng.below(4));
    const auto shape = [&](Point at) {
        if (n == 6) return triangle(at, quarter);
        return ring(n, at, rng.chance(0.5) ? quarter : rng.uniform(0, 6), rng.uniform(0.8, 1));
    };
    Problem problem = test::problem(rounded(shape({0.3, 0.3})), rounded(shape({0.7, 0.7})));
    // Rounding to 6 digits costs up to 5e-6 of the tolerance itself.
    const double deepest = digits < 1e7 ? -4e-6 : -9e-6;
    const double gaps[] = {deepest, -1e-6, -1e-15, 0, 1e-15, 1e-12, 1e-7, 5e-6, 1.1e-5, 1e-3};
    double left = 1, top = 0;
    for (const Point& p : problem.start) left = std::min(left, p.x);
    for (const Point& p : problem.goal) top = std::max(top, p.y);
    problem.obstacles = {{{0.01, 0.01}, {left - gaps[rng.below(10)], 0.6}},
                         {{0.01, top + gaps[rng.below(10)]}, {0.95, 0.99}}};
    if (rng.chance(0.3)) problem.requirements.bounds.low.x = left - gaps[rng.below(10)];
    return problem;
}

TEST(ChainConstraints, EveryValidEndIsInsideAndCanBeLeft) {
    std::size_t valid = 0;
    for_seeds(test::scaled(2000), [&](Rng& rng) {
        const Problem problem = tight_problem(rng);
        if (!invalid_ends(problem).empty()) return;
        ++valid;
        const PlanningFrame frame(problem);
        const ChainWorld world(frame.problem(),
                               rng.chance(0.5) ? Anchor::centroid : Anchor::first_asv);
        MotionChecker checker = world.make_checker();
        ASSERT_TRUE(checker.valid(world.start));
        ASSERT_TRUE(checker.valid(world.goal));
        // Off the box on the left, along it, and off the one above.
        Row away(world.start), down(world.goal);
        away[frame.transposed() ? 1 : 0] += 0.05;
        down[frame.transposed() ? 0 : 1] -= 0.05;
        EXPECT_TRUE(checker.valid(world.start, away));
        EXPECT_TRUE(checker.valid(away, world.start));
        EXPECT_TRUE(checker.valid(world.goal, down));
        Row along(world.start), into(world.start);
        along[frame.transposed() ? 0 : 1] += 0.05;
        into[frame.transposed() ? 1 : 0] -= 0.05;
        EXPECT_TRUE(checker.valid(world.start, along));
        EXPECT_FALSE(checker.valid(world.start, into));
    });
    EXPECT_GE(valid, test::scaled(2000) / 3);
}

}  // namespace
}  // namespace asv::core
