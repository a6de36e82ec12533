#include <array>
#include <cmath>
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

void mutate(Random& random, std::vector<Points>& states) {
    const std::size_t row = random.below(states.size());
    const auto at = states.begin() + static_cast<std::ptrdiff_t>(row);
    switch (random.below(7)) {
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

TEST(MutatedPaths, VerdictsAreThoseOfTheOracle) {
    std::array<std::size_t, check_count> failed{}, in_doubt{};
    std::size_t valid = 0;
    Random random(1);
    const std::size_t cases = test::scaled(20'000);
    for (std::size_t i = 0; i < cases; ++i) {
        SCOPED_TRACE("seed 1, case " + std::to_string(i));
        const test::Case made = mutated_case(random);
        const double tolerance = random.one_in(4) ? 0 : 1e-5;
        const auto expected = test::oracle_verdicts(made.problem, made.solution, tolerance);
        const ValidationReport report =
            validate(made.problem, made.solution, {.tolerance = tolerance});
        ASSERT_EQ(report.checks.size(), check_count);
        for (std::size_t k = 0; k < check_count; ++k) {
            if (expected[k] == Verdict::in_doubt) ++in_doubt[k];
            if (expected[k] == Verdict::in_doubt) continue;
            ASSERT_EQ(report.checks[k].ok(), expected[k] == Verdict::holds)
                << name(static_cast<Check>(k)) << ": " << describe(report.checks[k]);
            if (!report.checks[k].ok()) ++failed[k];
        }
        if (report.valid()) ++valid;
    }
    // Each verdict has been among the cases, and the oracle is seldom in doubt (with a tolerance of
    // 0 mostly), so that agreeing means something.
    EXPECT_GT(valid, cases / 20);
    for (std::size_t k = 0; k < check_count; ++k) {
        EXPECT_GT(failed[k], cases / 500) << name(static_cast<Check>(k));
        EXPECT_LT(in_doubt[k], cases / 3) << name(static_cast<Check>(k));
    }
}

}  // namespace
}  // namespace asv::core
