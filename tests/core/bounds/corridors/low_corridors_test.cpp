#include "core/bounds/corridors/low_corridors.hpp"

#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include "core/bounds/feasibility.hpp"
#include "core/generate/families.hpp"
#include "core/shapes/flat_chain.hpp"
#include "core/solve/solve.hpp"
#include "core/validation/validate.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using test::for_seeds;
using test::mirrored;
using test::reversed;
using test::scaled;
using test::transposed;

/// A corridor of a share of min_flat_height between two blocks, obstacles 1 and 2.
Problem corridor_of(std::size_t asv_count, double share, std::uint64_t seed = 1) {
    CorridorOptions options;
    options.chain.asv_count = asv_count;
    options.height.factor = share;
    Rng rng(seed);
    return corridor(options, rng);
}

void expect_too_low(const Problem& problem, const std::string& reason) {
    const Feasibility found = check_feasibility(problem);
    EXPECT_EQ(found.cause, Infeasibility::corridor_too_low);
    EXPECT_TRUE(found.proven_infeasible());
    EXPECT_EQ(found.reason, reason);
}

TEST(LowCorridors, AreTheReasonThatThereIsNoPath) {
    const Problem problem = corridor_of(7, 0.95);
    const std::string needed = ", and 0.022576 is needed";
    const std::string between = "no chain of 7 ASVs passes the corridor between obstacles ";
    const std::string high = between + "1 and 2: it is 0.021526 high" + needed;
    expect_too_low(problem, high);
    expect_too_low(mirrored(problem), high);
    expect_too_low(reversed(problem), high);
    expect_too_low(transposed(problem), between + "1 and 2: it is 0.021526 wide" + needed);
    Problem backwards = problem;
    for (auto* state : {&backwards.start, &backwards.goal}) std::ranges::reverse(*state);
    expect_too_low(backwards, high);
}

TEST(LowCorridors, AreClosedUpToHardlyLessThanTheFlattestChainNeeds) {
    for (const std::size_t n : {4u, 5u, 7u, 10u}) {
        EXPECT_EQ(check_feasibility(corridor_of(n, 0.985)).cause, Infeasibility::corridor_too_low)
            << n << " ASVs";
        EXPECT_EQ(check_feasibility(corridor_of(n, 1)).cause, Infeasibility::none) << n << " ASVs";
    }
    // The tolerance is a fiftieth of the area that three ASVs need.
    EXPECT_EQ(check_feasibility(corridor_of(3, 0.97)).cause, Infeasibility::corridor_too_low);
    EXPECT_EQ(check_feasibility(corridor_of(3, 1)).cause, Infeasibility::none);
}

TEST(LowCorridors, ThatAreShorterThanTheChainMayBePassed) {
    CorridorOptions options;
    options.chain.asv_count = 7;
    options.height.factor = 0.9;
    options.length = 0.299;
    Rng rng(1);
    const Problem problem = corridor(options, rng);
    EXPECT_TRUE(find_low_corridors(problem).empty());
}

/// A wall across the square with two corridors of these heights.
Problem two_corridors(double lower, double upper) {
    Problem problem = corridor_of(7, 0.95);
    const double left = problem.obstacles[0].low.x, right = problem.obstacles[0].high.x;
    problem.obstacles = {{{left, 0}, {right, 0.3}},
                         {{left, 0.3 + lower}, {right, 0.6}},
                         {{left, 0.6 + upper}, {right, 1}}};
    return problem;
}

TEST(LowCorridors, AllHaveToBeLow) {
    expect_too_low(two_corridors(0.02, 0.015),
                   "no chain of 7 ASVs passes the corridors between obstacles 1 and 2 (0.02 high) "
                   "and between obstacles 2 and 3 (0.015 high): 0.022576 is needed");
    EXPECT_EQ(check_feasibility(two_corridors(0.02, 0.023)).cause, Infeasibility::none);
    EXPECT_EQ(check_feasibility(two_corridors(0.023, 0.015)).cause, Infeasibility::none);
}

TEST(LowCorridors, OnlyThoseAreNamedThatAreInTheWay) {
    Problem problem = corridor_of(7, 0.95);
    // Another one in a corner, which leads nowhere.
    problem.obstacles.push_back({{0.02, 0.97}, {0.35, 0.99}});
    ASSERT_TRUE(validate_state(problem, problem.start).valid());
    ASSERT_TRUE(validate_state(problem, problem.goal).valid());
    EXPECT_GT(find_low_corridors(problem).size(), find_low_corridors(corridor_of(7, 0.95)).size());
    expect_too_low(problem,
                   "no chain of 7 ASVs passes the corridor between obstacles 1 and 2: it is "
                   "0.021526 high, and 0.022576 is needed");
}

TEST(LowCorridors, MayBeAlongTheBorder) {
    Problem problem = corridor_of(7, 0.95);
    const Box block = problem.obstacles[0];
    problem.obstacles = {{{block.low.x, 0.02}, {block.high.x, 1}}};
    const std::string name = "no chain of 7 ASVs passes the corridor between obstacle 1 and the ";
    const std::string numbers = " border: it is 0.02 high, and 0.022576 is needed";
    expect_too_low(problem, name + "lower" + numbers);
    problem.obstacles = {{{block.low.x, 0}, {block.high.x, 0.98}}};
    expect_too_low(problem, name + "upper" + numbers);
    problem.requirements.bounds = without_bounds();
    EXPECT_EQ(check_feasibility(problem).cause, Infeasibility::none) << "no border, a way around";
}

TEST(LowCorridors, AWallThatCanBeJumpedOverIsNone) {
    Problem problem = corridor_of(7, 1.5);
    const Box below = problem.obstacles[0], above = problem.obstacles[1];
    EXPECT_EQ(check_feasibility(problem).cause, Infeasibility::none);
    const double middle = (below.high.y + above.low.y) / 2;
    const auto with_wall = [&](double thickness) {
        Problem divided = problem;
        divided.obstacles.push_back(
            {{below.low.x, middle - thickness / 2}, {below.high.x, middle + thickness / 2}});
        return check_feasibility(divided).cause;
    };
    EXPECT_EQ(with_wall(0.0011), Infeasibility::corridor_too_low);
    EXPECT_EQ(with_wall(0.0009), Infeasibility::none);
}

TEST(LowCorridors, OfTouchingObstaclesCloseTheWayAsItIsMeant) {
    Problem problem = corridor_of(7, 0.95);
    // Two short obstacles that touch carry on the wall above the corridor's mouth.
    const Box upper = problem.obstacles[1];
    const double middle = (upper.low.x + upper.high.x) / 2;
    problem.obstacles[1].high.y = upper.low.y + 0.1;
    problem.obstacles.push_back({{middle - 0.02, upper.low.y + 0.1}, {middle + 0.02, 1}});
    const Feasibility found = check_feasibility(problem);
    EXPECT_EQ(found.cause, Infeasibility::separated_as_intended);
    EXPECT_FALSE(found.proven_infeasible());
    EXPECT_NE(found.reason.find("unless it slips through"), std::string::npos);
}

TEST(LowCorridors, SolveTellsThem) {
    const SolveResult result = solve(corridor_of(7, 0.95));
    EXPECT_EQ(result.status, SolveStatus::infeasible);
    EXPECT_EQ(result.reason,
              "no chain of 7 ASVs passes the corridor between obstacles 1 and 2: it is 0.021526 "
              "high, and 0.022576 is needed");
}

TEST(LowCorridors, AreNeverAReasonWhereThereIsAPath) {
    std::size_t solved = 0;
    for_seeds(std::max<std::size_t>(10, scaled(30)), [&](Rng& rng) {
        const std::size_t n = 3 + rng.below(10);
        Problem problem;
        try {
            problem = corridor_of(n, rng.uniform(0.9, 1.2), rng.bits());
        } catch (const std::exception&) {
            return;  // no room for start or goal
        }
        const bool proven = check_feasibility(problem).cause != Infeasibility::none;
        SolveOptions options;
        options.optimize = 0;
        options.max_iterations = 300;
        options.seed = rng.bits();
        options.time_limit = 1.9;  // so short that solve() looks for no proof itself
        const bool has_path = solve(problem, options).solution.has_value();
        EXPECT_FALSE(proven && has_path) << n << " ASVs";
        solved += has_path;
    });
    EXPECT_GT(solved, 0u);
}

}  // namespace
}  // namespace asv::core
