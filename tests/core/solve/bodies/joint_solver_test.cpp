#include <cmath>
#include <numbers>

#include "core/bounds/lower_bound.hpp"
#include "core/solve/solve.hpp"
#include "io/problem/problem_file.hpp"
#include "tests/kit/chains/arms.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/check_results.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"

/// Arms and points through solve().

namespace asv::core {
namespace {

using test::for_seeds;
using test::scaled;

TEST(Solve, FindsValidPathsForArmsAndPoints) {
    std::size_t solved = 0;
    for_seeds(scaled(30), [&](Rng& rng) {
        const Problem problem = test::arm_problem(rng);
        SolveOptions options{.seed = rng.bits(), .time_limit = 2, .optimize = 0};
        options.reverse = rng.chance(0.5);
        const SolveResult result = solve(problem, options);
        if (!result.solution) return;
        ++solved;
        const auto report =
            validate(problem, *result.solution, {.tolerance = 1e-5, .continuous = true});
        test::expect_valid(report);
        EXPECT_GE(result.solution->cost, cost_lower_bound(problem).total);
    });
    EXPECT_GT(solved, scaled(30) / 2);
}

TEST(Solve, AnArmInAnEmptyPlaneGoesStraight) {
    for_seeds(scaled(50), [](Rng& rng) {
        Problem problem = test::arm_problem(rng);
        problem.obstacles.clear();
        problem.requirements.bounds = without_bounds();
        const PlanarArm& arm = *problem.arm();
        double straight = 0;
        for (std::size_t i = 0; i < arm.links.size(); ++i) {
            double way = arm.goal[i] - arm.start[i];
            if (arm.joints[i].wraps) way = std::remainder(way, 2 * std::numbers::pi);
            straight += way * way;
        }
        const SolveResult result = solve(problem, {.seed = 1, .optimize = 0});
        ASSERT_TRUE(result.solution.has_value());
        EXPECT_NEAR(result.solution->cost, std::sqrt(straight), 1e-9);
        EXPECT_NEAR(cost_lower_bound(problem).total, std::sqrt(straight), 1e-2);
    });
}

// The other planners came to 3.78 to 4.5 after the same work, two trees with straight shortcuts
// alone to 3.86 to 4.22.
TEST(Solve, AnArmComesNearTheBestPathKnown) {
    constexpr double best_known = 3.737;
    const Problem problem =
        io::read_problem(test::testcase_file("bodies/arm-4-workshop.json")).problem;
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const SolveResult result =
            solve(problem, {.seed = seed, .time_limit = 600, .optimize = 0.5});
        ASSERT_TRUE(result.solution.has_value());
        EXPECT_LT(result.solution->cost, 1.01 * best_known) << "seed " << seed;
    }
}

TEST(Solve, ProvesThatAPointIsLockedIn) {
    Problem problem;
    problem.body = PointBody{};
    problem.start = {{0.1, 0.5}};
    problem.goal = {{0.9, 0.5}};
    problem.obstacles = {{{0.4, -1}, {0.6, 2}}};
    const SolveResult result = solve(problem, {.seed = 1, .time_limit = 20});
    EXPECT_EQ(result.status, SolveStatus::infeasible);
    EXPECT_NE(result.reason.find("the point"), std::string::npos) << result.reason;
}

Problem point_problem(const Point& start, const Point& goal, std::vector<Box> obstacles) {
    Problem problem;
    problem.body = PointBody{};
    problem.start = {start};
    problem.goal = {goal};
    problem.obstacles = std::move(obstacles);
    return problem;
}

/// Valid also between its steps, and as short as the bound, but for the margin at each bend.
void expect_shortest(const Problem& problem, const SolveResult& result) {
    ASSERT_TRUE(result.solution.has_value()) << result.reason;
    test::expect_valid(
        validate(problem, *result.solution, {.tolerance = 1e-5, .continuous = true}));
    Problem exact = problem;
    exact.requirements.tolerance = 0;
    const double shortest = cost_lower_bound(exact).total;
    EXPECT_GE(result.solution->cost, shortest * (1 - 1e-12));
    EXPECT_LE(result.solution->cost, shortest + 5e-4);
    EXPECT_TRUE(result.statistics.optimal);
}

TEST(Solve, APointTakesTheShortestPath) {
    for_seeds(scaled(30), [](Rng& rng) {
        Problem problem = point_problem({0.02, 0.5}, {0.98, 0.5}, {});
        for (int i = 0; i < 20; ++i) {
            const Point low{rng.uniform(0.05, 0.85), rng.uniform(0.02, 0.88)};
            problem.obstacles.push_back(
                {low, {low.x + rng.uniform(0.01, 0.1), low.y + rng.uniform(0.01, 0.1)}});
        }
        SolveOptions options{.seed = rng.bits(), .optimize = 0.1};
        options.reverse = rng.chance(0.5);
        options.threads = rng.chance(0.2) ? 2 : 1;
        expect_shortest(problem, solve(problem, options));
    });
}

TEST(Solve, APointGoesRoundObstaclesThatTouch) {
    // Side by side, corner by corner, and one at the border.
    const Problem problem = point_problem({0.1, 0.3}, {0.9, 0.3},
                                          {{{0.4, 0.2}, {0.5, 0.5}},
                                           {{0.5, 0.2}, {0.6, 0.6}},
                                           {{0.6, 0.6}, {0.7, 0.7}},
                                           {{0.45, 0}, {0.5, 0.2}}});
    const SolveResult result = solve(problem, {.seed = 1, .optimize = 0});
    expect_shortest(problem, result);
    EXPECT_GT(result.solution->cost, std::hypot(0.5, 0.4) + std::hypot(0.2, 0.4));
}

TEST(Solve, APointStartsAndEndsInTouch) {
    // At a corner, at a wall and at the border; on the same side and across.
    const std::vector<Box> boxes{{{0.2, 0.2}, {0.4, 0.8}}, {{0.6, 0.1}, {0.8, 0.9}}};
    const Point touching[] = {{0.2, 0.5}, {0.4, 0.8}, {0.6, 0.9}, {0.8, 0.1}, {0, 0.5}};
    for (const Point& start : touching)
        for (const Point& goal : touching) {
            if (start.x == goal.x) continue;
            SCOPED_TRACE(testing::Message()
                         << start.x << ' ' << start.y << " to " << goal.x << ' ' << goal.y);
            const Problem problem = point_problem(start, goal, boxes);
            if (!invalid_ends(problem).empty()) continue;
            expect_shortest(problem, solve(problem, {.seed = 1, .optimize = 0}));
        }
}

TEST(Solve, APointPassesAGapThatTheMarginNearlyCloses) {
    const Problem problem = point_problem({0.1, 0.5}, {0.9, 0.5},
                                          {{{0.4, -1}, {0.6, 0.4}}, {{0.4, 0.40003}, {0.6, 2}}});
    expect_shortest(problem, solve(problem, {.seed = 1, .optimize = 0}));
}

}  // namespace
}  // namespace asv::core
