#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/bounds/feasibility.hpp"
#include "core/generate/random_chain.hpp"
#include "core/shapes/chain_shapes.hpp"
#include "core/validation/validate.hpp"
#include "geometry/predicates/polygon.hpp"
#include "tests/kit/files/error_message.hpp"

/// Goals for starts that are given.

namespace asv::core {
namespace {

/// A start on the left of a wall, and all lengths times a factor; the goal is left out.
Problem world(std::size_t n, bool clockwise, double factor = 1) {
    Problem problem;
    Requirements& required = problem.requirements;
    for (double* length : {&required.broom_length, &required.max_step,
                           &required.area_radius_per_broom, &required.tolerance})
        *length *= factor;
    required.bounds.high = {factor, factor};
    problem.obstacles = {{{0.45 * factor, 0}, {0.5 * factor, 0.6 * factor}}};
    problem.start = arc_chain(n, required, {{0.1 * factor, 0.3 * factor}, 0, clockwise});
    problem.goal = problem.start;
    return problem;
}

bool is_valid(const Problem& problem, const std::vector<Point>& state) {
    return validate_state(problem, state, {.tolerance = problem.requirements.tolerance / 10})
        .valid();
}

TEST(DrawGoal, IsValidAndTurnsAsTheStartDoes) {
    for (const std::size_t n : {1U, 3U, 6U, 12U})
        for (const bool clockwise : {false, true})
            for (std::uint64_t seed = 1; seed <= 5; ++seed) {
                Problem problem = world(n, clockwise);
                const std::vector<Point> start = problem.start;
                Rng rng(seed);
                draw_goal(problem, {}, rng);
                EXPECT_EQ(problem.start, start);
                EXPECT_TRUE(is_valid(problem, problem.goal)) << n << ", seed " << seed;
                if (n == 1) continue;
                EXPECT_EQ(geometry::signed_area(problem.goal) < 0, clockwise) << "seed " << seed;
            }
}

TEST(DrawGoal, OfALargerWorldIsTheSameLarger) {
    constexpr double factor = 1024;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        Problem small = world(5, false), large = world(5, false, factor);
        Rng for_small(seed), for_large(seed);
        draw_goal(small, {}, for_small);
        draw_goal(large, {}, for_large);
        for (std::size_t i = 0; i < small.goal.size(); ++i)
            EXPECT_EQ(large.goal[i], (Point{factor * small.goal[i].x, factor * small.goal[i].y}))
                << "seed " << seed;
    }
}

TEST(DrawGoal, NeedsNoBounds) {
    Problem problem = world(4, false);
    problem.requirements.bounds = without_bounds();
    Rng rng(1);
    draw_goal(problem, {}, rng);
    EXPECT_TRUE(is_valid(problem, problem.goal));
}

TEST(DrawGoal, MayBeOutOfReachForCertain) {
    for (const Obstruction obstruction : {Obstruction::turned, Obstruction::fenced}) {
        Problem problem = world(4, false, 400);
        ChainOptions options;
        options.obstruction = obstruction;
        Rng rng(1);
        draw_goal(problem, options, rng);
        EXPECT_TRUE(is_valid(problem, problem.start) && is_valid(problem, problem.goal));
        EXPECT_NE(check_feasibility(problem).cause, Infeasibility::none);
    }
}

TEST(DrawGoal, IsForChainsOfOneOrOfThreeToTwoHundred) {
    Problem point{{{0, 0}}, {{0, 0}}, {}, {}, PointBody{}};
    Problem two = world(3, false), many = world(201, false, 1);
    two.start.pop_back();
    Rng rng(1);
    EXPECT_EQ(test::error_message<std::invalid_argument>([&] { draw_goal(point, {}, rng); }),
              "a goal is drawn for a chain of ASVs alone");
    EXPECT_THROW(draw_goal(two, {}, rng), std::invalid_argument);
    EXPECT_THROW(draw_goal(many, {}, rng), std::invalid_argument);
    Problem full = world(6, false);
    full.obstacles = {{{0, 0.35}, {1, 1}}, {{0.5, 0}, {1, 1}}, {{0, 0}, {1, 0.2}}};
    EXPECT_THROW(draw_goal(full, {.clearance = 0.1}, rng), NoRoom);
}

}  // namespace
}  // namespace asv::core
