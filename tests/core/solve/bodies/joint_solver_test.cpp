#include <cmath>
#include <numbers>

#include "core/bounds/lower_bound.hpp"
#include "core/solve/solve.hpp"
#include "tests/kit/chains/arms.hpp"
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

}  // namespace
}  // namespace asv::core
