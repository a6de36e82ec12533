#include "core/bounds/feasibility.hpp"

#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/bounds/seams.hpp"
#include "core/validation/validate.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/chains/wall_of_two.hpp"

namespace asv::core {
namespace {

using test::mirrored;
using test::reversed;

/// A wall in one piece across the square.
Problem walled_off(std::size_t asv_count) {
    Problem problem = test::wall_of_two(asv_count, 1);
    problem.obstacles = {{{0.5, -0.1}, {0.6, 1.1}}};
    return problem;
}

TEST(Feasibility, FindsNothingWhereThereIsAWay) {
    for (const std::size_t n : {3u, 5u, 7u}) {
        const Problem problem = test::wall_of_two(n, 0.9);
        ASSERT_TRUE(validate_state(problem, problem.start).valid());
        ASSERT_TRUE(validate_state(problem, problem.goal).valid());
        for (const Problem& p : {problem, mirrored(problem), reversed(problem)}) {
            const Feasibility feasibility = check_feasibility(p);
            EXPECT_EQ(feasibility.cause, Infeasibility::none) << n << " ASVs";
            EXPECT_FALSE(feasibility.proven_infeasible());
            EXPECT_TRUE(feasibility.reason.empty());
        }
    }
}

TEST(Feasibility, ASolidWallSeparates) {
    for (const std::size_t n : {3u, 7u}) {
        for (const Problem& p : {walled_off(n), mirrored(walled_off(n)), reversed(walled_off(n))}) {
            const Feasibility feasibility = check_feasibility(p);
            EXPECT_EQ(feasibility.cause, Infeasibility::separated);
            EXPECT_TRUE(feasibility.proven_infeasible());
            EXPECT_EQ(feasibility.asv, 0u);
            EXPECT_EQ(feasibility.reason, "obstacles separate the start of ASV 1 from its goal");
        }
    }
}

TEST(Feasibility, NamesTheAsvThatIsSeparated) {
    Problem problem = walled_off(3);
    problem.goal = problem.start;
    problem.goal[2].x = 0.65;
    EXPECT_EQ(check_feasibility(problem).asv, 2u);
}

TEST(Feasibility, TouchingBoxesAreAProofForShortChainsOnly) {
    EXPECT_EQ(check_feasibility(test::wall_of_two(3, 1)).cause, Infeasibility::separated);
    const Problem problem = test::wall_of_two(7, 1);
    // Far-fetched, but true: this problem has a solution.
    ASSERT_TRUE(validate(problem, test::squeeze_through(problem), {.continuous = true}).valid());
    const Feasibility feasibility = check_feasibility(problem);
    EXPECT_EQ(feasibility.cause, Infeasibility::separated_as_intended);
    EXPECT_FALSE(feasibility.proven_infeasible());
    EXPECT_EQ(feasibility.asv, 0u);
}

TEST(Feasibility, AGapWiderThanTheToleranceIsOpen) {
    Problem problem = test::wall_of_two(3, 1);
    problem.obstacles[0].high.y -= 2.1e-5;
    EXPECT_EQ(check_feasibility(problem).cause, Infeasibility::none);
    EXPECT_EQ(check_passages(problem).cause, Infeasibility::gates_closed) << "but no chain fits";
}

TEST(Feasibility, AThinWallMightBeJumpedOver) {
    Problem problem = walled_off(3);
    problem.obstacles[0].high.x = 0.5009;
    EXPECT_EQ(check_feasibility(problem).cause, Infeasibility::separated_as_intended);
}

TEST(Feasibility, TwoAsvsHaveNoArea) {
    Problem problem;
    problem.start = {{0.1, 0.1}, {0.15, 0.1}};
    problem.goal = {{0.1, 0.2}, {0.15, 0.2}};
    const Feasibility feasibility = check_feasibility(problem);
    EXPECT_EQ(feasibility.cause, Infeasibility::no_area);
    EXPECT_TRUE(feasibility.proven_infeasible());
    EXPECT_EQ(feasibility.reason, "a chain of 2 ASVs cannot enclose the area that is required");
}

TEST(Feasibility, AreaThatNoChainEncloses) {
    Problem problem = test::wall_of_two(7, 0.9);
    // A half circle 0.3 long has the radius 0.3 / pi.
    problem.requirements.area_radius_per_broom = 0.3 / std::numbers::pi / std::numbers::sqrt2 / 6;
    EXPECT_EQ(check_feasibility(problem).cause, Infeasibility::none);
    problem.requirements.area_radius_per_broom *= 1.01;
    EXPECT_EQ(check_feasibility(problem).cause, Infeasibility::no_area);
}

TEST(Feasibility, OppositeOrientation) {
    for (const std::size_t n : {3u, 7u}) {
        Problem problem = test::wall_of_two(n, 0.9);
        std::reverse(problem.goal.begin(), problem.goal.end());
        const Feasibility feasibility = check_feasibility(problem);
        EXPECT_EQ(feasibility.cause, Infeasibility::opposite_orientation);
        EXPECT_TRUE(feasibility.proven_infeasible());
        EXPECT_EQ(feasibility.reason,
                  "the chain turns left at the start and right at the goal; in between it would "
                  "have to enclose no area");
        EXPECT_EQ(check_feasibility(mirrored(problem)).cause, Infeasibility::opposite_orientation);
    }
    Problem leaping = test::wall_of_two(3, 0.9);
    std::reverse(leaping.goal.begin(), leaping.goal.end());
    leaping.requirements.max_step = 0.05;
    EXPECT_EQ(check_feasibility(leaping).cause, Infeasibility::none)
        << "with such steps the chain can turn inside out at once";
}

TEST(Seams, WhichAreImpassable) {
    const auto impassable = [](std::size_t n, double width, double depth) {
        Problem problem;
        problem.start.resize(n);
        return is_impassable({{}, width, depth}, problem);
    };
    EXPECT_TRUE(impassable(3, 2e-5, 0.05));
    EXPECT_TRUE(impassable(3, 2e-5, 0.01));
    EXPECT_FALSE(impassable(3, 2e-5, 0.005)) << "a joint can turn where the gap is so short";
    EXPECT_FALSE(impassable(3, 1e-3, 0.05)) << "a broom has play in a gap so wide";
    EXPECT_FALSE(impassable(2, 2e-5, 0.05));
    EXPECT_FALSE(impassable(4, 2e-5, 0.05)) << "three brooms as Z or U get through";
    EXPECT_TRUE(impassable(4, 2e-5, 0.12));
    EXPECT_FALSE(impassable(7, 2e-5, 0.1));
    EXPECT_TRUE(impassable(7, 2e-5, 0.33));
    EXPECT_FALSE(impassable(15, 2e-5, 0.33));
    for (std::size_t n = 3; n < 40; ++n) {
        EXPECT_TRUE(impassable(n, 2e-5, 0.06 * static_cast<double>(n))) << n << " ASVs";
        EXPECT_FALSE(impassable(n, 2e-5, 0)) << n << " ASVs, corners that meet";
    }
}

TEST(Seams, AreFoundBetweenSidesCornersAndTheBorder) {
    const auto count = [](const std::vector<Box>& boxes) {
        Problem problem;
        problem.obstacles = boxes;
        return find_seams(problem, 1.5e-5).size();
    };
    EXPECT_EQ(count({{{0.2, 0.2}, {0.4, 0.4}}, {{0.4, 0.2}, {0.6, 0.4}}}), 1u);
    EXPECT_EQ(count({{{0.2, 0.2}, {0.4, 0.4}}, {{0.40001, 0.3}, {0.6, 0.4}}}), 1u);
    EXPECT_EQ(count({{{0.2, 0.2}, {0.4, 0.4}}, {{0.40002, 0.3}, {0.6, 0.4}}}), 0u);
    EXPECT_EQ(count({{{0.2, 0.2}, {0.4, 0.4}}, {{0.399, 0.2}, {0.6, 0.4}}}), 0u) << "overlap";
    EXPECT_GE(count({{{0.2, 0.2}, {0.4, 0.4}}, {{0.4, 0.4}, {0.6, 0.6}}}), 1u) << "corner";
    EXPECT_EQ(count({{{0, 0.2}, {0.4, 0.4}}}), 1u) << "border";
    EXPECT_EQ(count({{{-0.1, 0.2}, {0.4, 0.4}}}), 0u) << "beyond the border";
    EXPECT_EQ(count({{{0.2, 0.7}, {0.4, 1}}}), 1u) << "border above";
}

}  // namespace
}  // namespace asv::core
