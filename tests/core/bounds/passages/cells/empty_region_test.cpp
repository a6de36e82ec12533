#include "core/bounds/passages/cells/empty_region.hpp"

#include <cmath>
#include <cstddef>
#include <iostream>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/bounds/corridors/low_corridors.hpp"
#include "core/generate/families.hpp"
#include "core/solve/solve.hpp"
#include "core/validation/validate.hpp"
#include "tests/kit/chains/chains.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using Answer = EmptyRegion::Answer;

Answer answer(const Problem& problem, const Box& middle) {
    std::size_t cells = 1'000'000;
    return EmptyRegion(problem, middle, cells).examine(cells);
}

/// Of the very place where the middle of the state is, and the very heading of one of its brooms.
Answer answer_around(const std::vector<Point>& state, const Problem& problem, std::size_t broom) {
    const Point middle = middle_of_chain(state);
    const Point &from = state[broom], &to = state[broom + 1];
    const double heading = std::atan2(to.y - from.y, to.x - from.x);
    const BroomHeading rounded{broom, {heading - 1e-9, heading + 1e-9}};
    std::size_t cells = 20'000;
    return EmptyRegion(problem, {middle, middle}, rounded, cells).examine(cells);
}

/// A corridor of a share of min_flat_height, longer than the chain, which turns left.
Problem left_turning_corridor(std::size_t asv_count, double share) {
    CorridorOptions options;
    options.chain.asv_count = asv_count;
    options.chain.orientation = Orientation::counter_clockwise;
    options.height.factor = share;
    Rng rng(1);
    return corridor(options, rng);
}

/// The middle of the corridor, a little wide, from wall to wall.
Box middle_of_corridor(const Problem& problem) {
    const Box &lower = problem.obstacles[0], &upper = problem.obstacles[1];
    const double x = geometry::centre(lower).x;
    return {{x - 0.0005, lower.high.y - 0.0005}, {x + 0.0005, upper.low.y + 0.0005}};
}

TEST(EmptyRegion, IsTheMiddleOfACorridorThatIsTooLow) {
    for (const std::size_t n : {3u, 4u, 5u, 6u, 7u, 8u}) {
        const Problem low = left_turning_corridor(n, 0.9), high = left_turning_corridor(n, 1.01);
        constexpr std::size_t most = 1'000'000;
        std::size_t cells = most;
        EmptyRegion region(low, middle_of_corridor(low), most);
        EXPECT_EQ(region.examine(cells), Answer::empty) << n << " ASVs";
        std::cout << n << " ASVs: " << most - cells << " cells\n";
        EXPECT_EQ(answer(high, middle_of_corridor(high)), Answer::may_not_be) << n << " ASVs";
    }
    const Problem hardly_low = left_turning_corridor(5, 0.97);
    EXPECT_EQ(answer(hardly_low, middle_of_corridor(hardly_low)), Answer::empty);
}

TEST(EmptyRegion, IsNoneWhereThereIsRoom) {
    Problem problem = left_turning_corridor(5, 0.5);
    problem.obstacles.clear();
    EXPECT_EQ(answer(problem, {{0.5, 0.5}, {0.5, 0.5}}), Answer::may_not_be);
    EXPECT_EQ(answer(problem, {{0, 0}, {1e-3, 1e-3}}), Answer::may_not_be) << "round the corner";
    EXPECT_EQ(answer(problem, {{0.5, -0.02}, {0.6, -0.01}}), Answer::empty) << "out of bounds";
    problem.obstacles = {{{0.4, 0.4}, {0.6, 0.6}}};
    EXPECT_EQ(answer(problem, {{0.45, 0.45}, {0.55, 0.55}}), Answer::empty) << "in an obstacle";
}

TEST(EmptyRegion, IsFoundInPortionsAsAtOnce) {
    const Problem problem = left_turning_corridor(5, 0.96);
    const Box middle = middle_of_corridor(problem);
    std::size_t cells = 1'000'000;
    EXPECT_EQ(EmptyRegion(problem, middle, cells).examine(cells), Answer::empty);
    const std::size_t needed = 1'000'000 - cells;
    EmptyRegion region(problem, middle, needed);
    std::size_t spent = 0;
    for (Answer found = Answer::unknown; found == Answer::unknown;) {
        std::size_t portion = 1000;
        found = region.examine(portion);
        spent += 1000 - portion;
        EXPECT_EQ(found == Answer::unknown, spent < needed);
    }
    EXPECT_EQ(spent, needed);
    EmptyRegion too_few(problem, middle, needed - 1);
    cells = needed;
    EXPECT_EQ(too_few.examine(cells), Answer::may_not_be);
    EXPECT_EQ(cells, 1u);
}

TEST(EmptyRegion, IsAQuestionOfTheHeading) {
    const Problem problem = left_turning_corridor(4, 1.3);
    const Box middle = middle_of_corridor(problem);
    const auto with_heading = [&](double heading) {
        std::size_t cells = 100'000;
        const BroomHeading wanted{1, {heading - 0.1, heading + 0.1}};
        return EmptyRegion(problem, middle, wanted, cells).examine(cells);
    };
    EXPECT_EQ(with_heading(0), Answer::may_not_be);
    EXPECT_EQ(with_heading(2 * std::numbers::pi), Answer::may_not_be);
    EXPECT_EQ(with_heading(std::numbers::pi), Answer::may_not_be);
    EXPECT_EQ(with_heading(std::numbers::pi / 2), Answer::empty) << "across the corridor";
    EXPECT_EQ(with_heading(3 * std::numbers::pi / 2), Answer::empty);
}

/// A problem of one of the families with narrow passages.
Problem narrow_problem(std::size_t asv_count, Rng& rng) {
    ChainOptions chain;
    chain.asv_count = asv_count;
    chain.orientation = Orientation::counter_clockwise;
    const double length = 0.05 * static_cast<double>(asv_count - 1);
    if (rng.chance(0.5)) {
        CorridorOptions options;
        options.chain = chain;
        options.length = 0.7 * length;
        options.height.factor = rng.uniform(0.8, 1.1);
        return corridor(options, rng);
    }
    GauntletOptions options;
    options.chain = chain;
    options.thickness = 0.6 * length;
    options.height.factor = rng.uniform(0.8, 1.1);
    return gauntlet(options, rng);
}

TEST(EmptyRegion, IsNoneWhereAStateOfAPathHasItsMiddle) {
    std::size_t states = 0;
    test::for_seeds(5, [&](Rng& rng) {
        const Problem problem = narrow_problem(3 + rng.below(6), rng);
        SolveOptions options;
        options.max_iterations = 20'000;
        options.optimize = 0.1;
        const SolveResult result = solve(problem, options);
        if (!result.solution) return;
        const Path& path = result.solution->path;
        for (std::size_t i = 0; i < path.size(); i += 97, ++states) {
            const auto state = path.state(i);
            const std::size_t broom = rng.below(problem.asv_count() - 1);
            EXPECT_NE(answer_around({state.begin(), state.end()}, problem, broom), Answer::empty)
                << "state " << i;
        }
    });
    EXPECT_GT(states, 50u);
}

/// A chain that turns left somewhere in the square, its brooms as long or as short as the tolerance
/// allows.
std::vector<Point> extreme_chain(std::size_t asv_count, Rng& rng) {
    ChainOptions options;
    options.asv_count = asv_count;
    options.area_margin = 0;
    options.min_turn = 0;
    options.min_closing_side = 0;
    const std::vector<double> turns = random_turns(options, {}, rng);
    std::vector<Point> chain =
        test::chain_with_turns({0.5, 0.5}, rng.uniform(-std::numbers::pi, std::numbers::pi), turns);
    const double scale = 1 + (rng.chance(0.5) ? 1 : -1) * 0.99 * 1e-5 / 0.05;
    for (Point& asv : chain) asv = {0.5 + scale * (asv.x - 0.5), 0.5 + scale * (asv.y - 0.5)};
    return chain;
}

/// A box with a corner on a broom of the chain, as far across it as the tolerance allows.
Box box_at(const std::vector<Point>& chain, Rng& rng) {
    const std::size_t broom = rng.below(chain.size() - 1);
    const double share = rng.uniform();
    const Point &a = chain[broom], &b = chain[broom + 1];
    const Point at{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
    // On the side of the broom where only the corner is.
    const bool rises = (b.x - a.x) * (b.y - a.y) > 0;
    const double side = rng.chance(0.5) ? 1 : -1;
    const double right = side, up = rises ? -side : side;
    const Point far{at.x + right * rng.uniform(0.01, 0.1), at.y + up * rng.uniform(0.01, 0.1)};
    const Point near{at.x - right * 0.99e-5, at.y - up * 0.99e-5};
    return geometry::bounds(geometry::Segment{near, far});
}

TEST(EmptyRegion, IsNoneWhereAChainTouchesWhateverItCan) {
    std::size_t valid = 0;
    test::for_seeds(test::scaled(150), [&](Rng& rng) {
        const std::vector<Point> chain = extreme_chain(3 + rng.below(7), rng);
        Problem problem = test::problem(chain, chain);
        for (std::size_t tries = 0; tries < 12; ++tries) {
            problem.obstacles.push_back(box_at(chain, rng));
            if (!validate_state(problem, chain).valid()) problem.obstacles.pop_back();
        }
        if (!validate_state(problem, chain).valid()) return;
        ++valid;
        EXPECT_NE(answer_around(chain, problem, rng.below(chain.size() - 1)), Answer::empty);
    });
    EXPECT_GT(valid, test::scaled(75));
}

}  // namespace
}  // namespace asv::core
