#include <array>
#include <cmath>
#include <iostream>
#include <string>

#include <gtest/gtest.h>

#include "core/validation/validate.hpp"
#include "tests/core/validation/path_oracle.hpp"
#include "tests/kit/chains/paths.hpp"
#include "tests/kit/geometry/random_boxes.hpp"
#include "tests/kit/random.hpp"
#include "tests/kit/scaled.hpp"

/// Good paths that something has happened to: no verdict of the validator is another than the
/// oracle's.

namespace asv::core {
namespace {

using test::Points;
using test::Random;
using test::Verdict;

/// A ring that turns on its way, some steps of it, mostly within the bounds and clear of boxes.
std::vector<Points> path_states(Random& random) {
    const std::size_t asv_count = 3 + random.below(8);
    const double x = random.uniform(0, 1), y = random.uniform(0, 1);
    const double heading = random.uniform(0, 6), closing = random.uniform(0.3, 0.95);
    const double dx = random.uniform(-5e-4, 5e-4), turn = random.uniform(-5e-3, 5e-3);
    std::vector<Points> states;
    const std::size_t count = 2 + random.below(8);
    for (std::size_t i = 0; i < count; ++i) {
        const auto steps = static_cast<double>(i);
        states.push_back(
            test::ring(asv_count, {x + dx * steps, y}, heading + turn * steps, closing));
    }
    return states;
}

/// One ASV is pushed, by 1e-12 to 1e-2.
void push(Random& random, Points& state) {
    const double length = std::pow(10, random.uniform(-12, -2)) * (random.one_in(2) ? 1 : -1);
    Point& point = state[random.below(state.size())];
    (random.one_in(2) ? point.x : point.y) += length;
}

/// The chain is folded at one ASV, to a little less or more than half a turn.
void fold(Random& random, Points& state) {
    const std::size_t at = 1 + random.below(state.size() - 2);
    const double heading =
        std::atan2(state[at - 1].y - state[at].y, state[at - 1].x - state[at].x) +
        std::pow(10, random.uniform(-10, -1)) * (random.one_in(2) ? 1 : -1);
    state[at + 1] = {state[at].x + 0.05 * std::cos(heading),
                     state[at].y + 0.05 * std::sin(heading)};
}

/// Makes a chain of three so flat that its area is just above or below the least.
void flatten(Random& random, Points& state) {
    const double least = Requirements{}.min_area(3) - (random.one_in(2) ? 1e-5 : 0);
    const double turn = std::asin(2 * least / (0.05 * 0.05)) +
                        std::pow(10, random.uniform(-10, -2)) * (random.one_in(2) ? 1 : -1);
    state = test::chain_with_turns(state[0], random.uniform(0, 6), {turn});
}

/// At a limit, or beside it by one bit to all of it.
double near_limit(Random& random, double limit) {
    const double off = std::ldexp(random.uniform(0.5, 1), -static_cast<int>(random.below(56)));
    return limit * (random.one_in(8) ? 1 : 1 + (random.one_in(2) ? off : -off));
}

/// Near a length, as it is or with a tolerance that it may be off by.
double longest(Random& random, double length, double tolerance) {
    const double limit = random.one_in(2) ? length + tolerance : length;
    return near_limit(random, limit);
}

/// A broom is as long as it may be, or as short.
void stretch(Random& random, Points& state) {
    const std::size_t at = 1 + random.below(state.size() - 1);
    const double heading = random.uniform(0, 6);
    const double length = longest(random, 0.05, random.one_in(2) ? 1e-5 : -1e-5);
    state[at] = {state[at - 1].x + length * std::cos(heading),
                 state[at - 1].y + length * std::sin(heading)};
}

/// One ASV goes as far from the state before as it may.
void stride(Random& random, const Points& before, Points& state) {
    const std::size_t at = random.below(state.size());
    const double heading = random.uniform(0, 6), length = longest(random, 1e-3, 1e-5);
    state[at] = {before[at].x + length * std::cos(heading),
                 before[at].y + length * std::sin(heading)};
}

/// The chain turns at one ASV against its orientation, by as much as counts as straight.
void straighten(Random& random, Points& state) {
    const std::size_t at = 1 + random.below(state.size() - 2);
    const double heading =
        std::atan2(state[at].y - state[at - 1].y, state[at].x - state[at - 1].x) +
        near_limit(random, 1e-5) * (random.one_in(2) ? 1 : -1);
    state[at + 1] = {state[at].x + 0.05 * std::cos(heading),
                     state[at].y + 0.05 * std::sin(heading)};
}

/// One ASV is at a side of the bounds.
void move_to_the_bounds(Random& random, Points& state) {
    Point& point = state[random.below(state.size())];
    const double beyond = random.one_in(2) ? near_limit(random, 1e-5) : 0;
    (random.one_in(2) ? point.x : point.y) = random.one_in(2) ? 1 + beyond : -beyond;
}

void mutate(Random& random, std::vector<Points>& states) {
    const std::size_t row = random.below(states.size());
    const auto at = states.begin() + static_cast<std::ptrdiff_t>(row);
    switch (random.below(11)) {
        case 0:
            if (states.size() > 1) states.erase(at);
            break;
        case 1:
            states.insert(at, Points(*at));
            break;
        case 2:
            std::swap(*at, states[random.below(states.size())]);
            break;
        case 3:  // a corner is cut
            if (states.size() > 2) states.erase(states.begin() + 1, states.end() - 1);
            break;
        case 4:
            fold(random, *at);
            break;
        case 5:
            if (at->size() == 3) flatten(random, *at);
            break;
        case 6:
            stretch(random, *at);
            break;
        case 7:
            if (row > 0) stride(random, states[row - 1], *at);
            break;
        case 8:
            straighten(random, *at);
            break;
        case 9:
            move_to_the_bounds(random, *at);
            break;
        default:
            push(random, *at);
            break;
    }
}

test::Case mutated_case(Random& random) {
    std::vector<Points> states = path_states(random);
    test::Case made = test::case_of(states);
    made.problem.obstacles = test::random_boxes_some_thin(random, random.below(4), 0.2);
    for (std::size_t i = random.below(3); i > 0; --i) mutate(random, states);
    made.solution.path = test::path_of(states);
    made.solution.cost = test::cost_of(made.solution.path);
    if (random.one_in(3)) made.solution.cost += std::pow(10, random.uniform(-12, -2));
    return made;
}

/// Of one check, over all paths and tolerances.
struct Tally {
    std::size_t held = 0, failed = 0, in_doubt = 0;
};

using Tallies = std::array<Tally, check_count>;

void print(const Tallies& tallies) {
    for (std::size_t k = 0; k < check_count; ++k)
        std::cout << name(static_cast<Check>(k)) << ": " << tallies[k].held << " hold, "
                  << tallies[k].failed << " fail, " << tallies[k].in_doubt << " in doubt\n";
}

/// Is each verdict of the validator that of the oracle?
void compare(const test::Case& made, double tolerance, Tallies& tallies) {
    const auto expected = test::oracle_verdicts(made.problem, made.solution, tolerance);
    const ValidationReport report = validate(made.problem, made.solution, {.tolerance = tolerance});
    ASSERT_EQ(report.checks.size(), check_count);
    for (std::size_t k = 0; k < check_count; ++k) {
        if (expected[k] == Verdict::in_doubt) {
            ++tallies[k].in_doubt;
            continue;
        }
        EXPECT_EQ(report.checks[k].ok(), expected[k] == Verdict::holds)
            << name(static_cast<Check>(k)) << ": " << describe(report.checks[k]);
        ++(report.checks[k].ok() ? tallies[k].held : tallies[k].failed);
    }
}

TEST(MutatedPaths, VerdictsAreThoseOfTheOracle) {
    Tallies tallies, without_tolerance;
    Random random(1);
    const std::size_t cases = test::scaled(6'000);
    for (std::size_t i = 0; i < cases; ++i) {
        SCOPED_TRACE("seed 1, case " + std::to_string(i));
        const test::Case made = mutated_case(random);
        compare(made, 1e-5, tallies);
        compare(made, 0, without_tolerance);
    }
    std::cout << cases << " paths with a tolerance of 1e-5\n";
    print(tallies);
    std::cout << "and of 0\n";
    print(without_tolerance);
    // Each verdict has been among the cases, and the oracle is seldom in doubt, so that agreeing
    // means something. Without tolerance, brooms and costs are as long as they round.
    for (std::size_t k = 0; k < check_count; ++k) {
        EXPECT_GT(tallies[k].held, cases / 20) << name(static_cast<Check>(k));
        EXPECT_GT(tallies[k].failed, cases / 500) << name(static_cast<Check>(k));
        EXPECT_LT(tallies[k].in_doubt, cases / 30) << name(static_cast<Check>(k));
        EXPECT_GT(without_tolerance[k].failed, cases / 500) << name(static_cast<Check>(k));
    }
}

}  // namespace
}  // namespace asv::core
