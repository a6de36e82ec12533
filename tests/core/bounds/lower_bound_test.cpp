#include "core/bounds/lower_bound.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/validation/validate.hpp"
#include "geometry/free_plane/free_plane.hpp"
#include "tests/kit/chains/wall_of_two.hpp"
#include "tests/kit/random.hpp"

namespace asv::core {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Three ASVs that stand so close to a point that they are as good as there.
std::vector<Point> near(const Point& point) {
    return {point, {point.x + 1e-6, point.y}, {point.x, point.y + 1e-6}};
}

Problem three_from_to(const Point& start, const Point& goal, std::vector<Box> obstacles) {
    Problem problem;
    problem.start = near(start);
    problem.goal = near(goal);
    problem.obstacles = std::move(obstacles);
    return problem;
}

TEST(CostLowerBound, IsTheSumOfTheStraightLinesInTheOpen) {
    const CostLowerBound bound = cost_lower_bound(three_from_to({0.1, 0.1}, {0.4, 0.5}, {}));
    EXPECT_EQ(bound.lengths.size(), 3u);
    EXPECT_DOUBLE_EQ(bound.total, bound.lengths[0] + bound.lengths[1] + bound.lengths[2]);
    EXPECT_LE(bound.total, 1.5);
    EXPECT_NEAR(bound.total, 1.5, 1e-4);
    EXPECT_EQ(cost_lower_bound(three_from_to({0.1, 0.1}, {0.1, 0.1}, {})).total, 0);
}

TEST(StepsLowerBound, AreThoseOfTheLongestWayOfAnAsv) {
    Problem problem = three_from_to({0.1, 0.1}, {0.4, 0.5}, {});
    // 0.5 less the tolerance at both ends, in steps of 0.001.
    EXPECT_EQ(steps_lower_bound(problem, cost_lower_bound(problem)), 500U);
    problem.requirements.max_step = 0.01;
    EXPECT_EQ(steps_lower_bound(problem, cost_lower_bound(problem)), 50U);
    EXPECT_EQ(steps_lower_bound(problem, {infinity, {infinity}}), 0U);
    problem.body = PlanarArm{};
    EXPECT_EQ(steps_lower_bound(problem, {1, {1}}), 0U) << "an arm's lengths are angles";
}

TEST(CostLowerBound, ASingleAsvHasNoBroomAndMeetsNothing) {
    Problem problem;
    problem.start = {{0.1, 0.5}};
    problem.goal = {{0.9, 0.5}};
    problem.obstacles = {{{0.4, -1}, {0.6, 2}}};
    EXPECT_NEAR(cost_lower_bound(problem).total, 0.8, 1e-4);
    EXPECT_NEAR(cost_lower_bound(problem, Reading::literal).total, 0.8, 1e-4);
}

TEST(CostLowerBound, GoesRoundTheShrunkBox) {
    const Box wall{{0.5, -0.2}, {0.6, 0.7}};
    const double over = std::hypot(0.1, 0.2) * 2 + 0.1;
    const Problem problem = three_from_to({0.4, 0.5}, {0.7, 0.5}, {wall});
    for (const Reading reading : {Reading::intended, Reading::literal}) {
        const CostLowerBound bound = cost_lower_bound(problem, reading);
        EXPECT_LE(bound.lengths[0], over);
        EXPECT_NEAR(bound.lengths[0], over, reading == Reading::intended ? 1e-4 : 2e-3);
    }
}

TEST(CostLowerBound, IsSmallerWithLessEffortAndStillABound) {
    std::vector<Box> posts;
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j) {
            const Point at{0.26 + 0.025 * i, 0.26 + 0.025 * j};
            posts.push_back({at, {at.x + 0.015, at.y + 0.015}});
        }
    const Problem problem = three_from_to({0.1, 0.1}, {0.85, 0.85}, posts);
    const double all = cost_lower_bound(problem).total;
    double last = 0;
    for (const std::size_t effort : {0U, 30U, 300U, 3000U}) {
        const double bound = cost_lower_bound(problem, Reading::intended, effort).total;
        EXPECT_GE(bound, last);
        EXPECT_LE(bound, all);
        last = bound;
    }
    EXPECT_GT(last, 0);
}

TEST(CostLowerBound, NeverExceedsAPathThatTheValidatorAccepts) {
    const Problem problem = test::wall_of_two(7, 0.95);
    const Solution squeezed = test::squeeze_through(problem);
    const ValidationReport report = validate(problem, squeezed, {.continuous = true});
    for (const CheckResult& check : report.checks) EXPECT_TRUE(check.ok()) << describe(check);
    EXPECT_LE(cost_lower_bound(problem, Reading::literal).total, squeezed.cost);
    EXPECT_GT(cost_lower_bound(problem, Reading::intended).total, squeezed.cost)
        << "the example shows nothing: the two readings need not differ here";
}

TEST(CostLowerBound, AJumpMayCutACorner) {
    const Requirements requirements;
    const double longest_step = requirements.max_step + requirements.tolerance;
    // The corner (0.5, 0.5) as it is after shrinking, and the line across it on which one step just
    // gets from one side of the box to the other.
    const double corner = 0.5 - requirements.tolerance;
    const double inside = longest_step / std::numbers::sqrt2;
    const Point from{corner - 0.003, corner + 0.003 - inside};
    const Point to{corner + 0.003 - inside, corner - 0.003};
    const double straight = std::hypot(from.x - to.x, from.y - to.y);
    const Problem problem = three_from_to(from, to, {{{-0.1, -0.1}, {0.5, 0.5}}});
    EXPECT_LE(cost_lower_bound(problem, Reading::literal).lengths[0], straight);
    EXPECT_GT(cost_lower_bound(problem, Reading::intended).lengths[0], straight);
}

TEST(CostLowerBound, AgreesWithSealedSpaceOnAGrid) {
    constexpr int side = 12;
    const auto at = [](std::uint64_t i) { return static_cast<double>(i) / side; };
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        test::Random random(seed);
        const auto draw = [&](std::size_t count) { return random.below(count); };
        std::vector<Box> boxes;
        for (std::uint64_t i = 0; i < 2 + seed % 14; ++i) {
            const std::uint64_t x = draw(side);
            const std::uint64_t y = draw(side);
            boxes.push_back({{at(x), at(y)}, {at(x + 1 + draw(5)), at(y + 1 + draw(5))}});
        }
        geometry::FreePlane exact(boxes, {{0, 0}, {1, 1}});
        for (int pair = 0; pair < 4; ++pair) {
            const Point from{at(draw(side)) + 0.03, at(draw(side)) + 0.03};
            const Point to{at(draw(side)) + 0.05, at(draw(side)) + 0.05};
            if (!exact.is_free(from) || !exact.is_free(to)) continue;
            const double expected = exact.shortest_path(from, to);
            const double found = cost_lower_bound(three_from_to(from, to, boxes)).lengths[0];
            if (std::isinf(expected)) {
                ASSERT_EQ(found, infinity) << "seed " << seed << ", pair " << pair;
            } else {
                ASSERT_LE(found, expected) << "seed " << seed << ", pair " << pair;
                ASSERT_GE(found, expected - 1e-3) << "seed " << seed << ", pair " << pair;
            }
        }
    }
}

TEST(CostLowerBound, ABroomInTheSeamOpensIt) {
    Problem problem = test::wall_of_two(7, 1);
    EXPECT_EQ(cost_lower_bound(problem).total, infinity);
    problem.goal = problem.start;
    for (Point& point : problem.goal) point.x += 0.08;
    problem.goal[6] = {0.57, 0.5};
    problem.goal[5] = {0.52, 0.5};
    EXPECT_LT(cost_lower_bound(problem).lengths[6], 0.1);
}

TEST(CostLowerBound, ManyBoxesThatTouch) {
    // A hundred and fifty walls of small boxes, each with a door at the other end than the last.
    constexpr int side = 301;
    const auto at = [](int i) { return static_cast<double>(i) / side; };
    Problem problem = three_from_to({0.001, 0.001}, {0.999, 0.999}, {});
    for (int y = 1; y < side; y += 2) {
        for (int x = 0; x < side; ++x) {
            if (x == (y % 4 == 1 ? side - 1 : 0)) continue;
            problem.obstacles.push_back({{at(x), at(y)}, {at(x + 1), at(y + 1)}});
        }
    }
    const double length = cost_lower_bound(problem).lengths[0];
    EXPECT_GT(length, 150);
    EXPECT_LT(length, 151);
}

}  // namespace
}  // namespace asv::core
