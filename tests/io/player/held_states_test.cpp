#include "io/player/held_states.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "io/player/player.hpp"
#include "tests/kit/files/drawing_samples.hpp"

namespace asv::io {
namespace {

using test::sample;

/// Nothing but what the choice looks at: so many states that measure something else each.
Exhibit long_exhibit(std::size_t states) {
    Exhibit exhibit;
    exhibit.measures.resize(states);
    for (std::size_t i = 0; i < states; ++i) {
        const double t = 0.37 * static_cast<double>(i);
        StateMeasures& measures = exhibit.measures[i];
        measures.clearance = Clearance{1.5 + std::sin(t), 0, 0};
        measures.area = 1.5 + std::cos(1.7 * t);
        measures.tightest_turn = 1.5 + std::sin(0.3 * t);
    }
    return exhibit;
}

bool holds(const std::vector<std::size_t>& held, std::size_t state) {
    return std::binary_search(held.begin(), held.end(), state);
}

core::CheckResult failed(core::Check check, std::size_t state) {
    core::CheckResult result;
    result.check = check;
    result.failures = 1;
    result.worst = core::Offender{};
    result.worst->state = state;
    result.worst->room = -1;
    return result;
}

TEST(HeldStates, AreAllWhereThereIsRoom) {
    const std::vector<std::size_t> held = held_states(long_exhibit(500), 500);
    ASSERT_EQ(held.size(), 500U);
    for (std::size_t i = 0; i < held.size(); ++i) ASSERT_EQ(held[i], i);
    EXPECT_TRUE(held_states(Exhibit{}, 500).empty());
}

TEST(HeldStates, KeepEveryExtremeOfALongPath) {
    Exhibit exhibit = long_exhibit(1'000'000);
    exhibit.measures[123'456].clearance->distance = 1e-6;
    exhibit.measures[234'567].area = 1e-6;
    exhibit.measures[345'678].tightest_turn = std::numbers::pi;
    exhibit.report.checks = {failed(core::Check::steps, 456'789)};
    const std::vector<std::size_t> held = held_states(exhibit, 20'000);
    EXPECT_LE(held.size(), 20'000U);
    EXPECT_GT(held.size(), 10'000U);
    EXPECT_TRUE(std::is_sorted(held.begin(), held.end()));
    EXPECT_EQ(std::set<std::size_t>(held.begin(), held.end()).size(), held.size()) << "each once";
    for (const std::size_t state : {0U, 123'456U, 234'567U, 345'678U, 456'789U, 999'999U})
        EXPECT_TRUE(holds(held, state)) << state;
    // No stretch of the way is without a state.
    for (std::size_t i = 1; i < held.size(); ++i) ASSERT_LE(held[i] - held[i - 1], 500U);
}

TEST(HeldStates, OfViolationsTheWorstAndAnEvenChoice) {
    Exhibit exhibit = long_exhibit(1000);
    for (std::size_t i = 0; i < 1000; ++i) {
        Violation violation;
        violation.check = core::Check::bounds;
        violation.offender.state = i;
        exhibit.violations.push_back(violation);
    }
    exhibit.report.checks = {failed(core::Check::bounds, 777)};
    const std::vector<std::size_t> all = held_states(exhibit, 1000);
    EXPECT_EQ(held_violations(exhibit, all, 1000).size(), 1000U);
    const std::vector<Violation> some = held_violations(exhibit, all, 100);
    ASSERT_EQ(some.size(), 100U);
    EXPECT_EQ(some.front().offender.state, 777U);
    for (std::size_t i = 2; i < some.size(); ++i)
        EXPECT_NEAR(static_cast<double>(some[i].offender.state - some[i - 1].offender.state), 10,
                    2);
}

TEST(HeldStates, APageOfAMillionStepsStaysBelowFiveMegabytes) {
    // Not measured and validated, which would take long; in circles, so that nothing is saved by
    // straight lines.
    Exhibit exhibit = long_exhibit(1'000'001);
    static_cast<ExhibitInput&>(exhibit) = sample(7, {{0.1, 0.3}, {0.2, 0.3}}, {});
    const std::vector<geometry::Point> start = exhibit.problem.start;
    exhibit.solution->path = core::Path(7);
    std::vector<geometry::Point> state = start;
    for (int i = 0; i <= 1'000'000; ++i) {
        const double t = 0.004 * i;
        for (std::size_t k = 0; k < start.size(); ++k)
            state[k] = {start[k].x + 0.1 - 0.1 * std::cos(t), start[k].y + 0.1 * std::sin(t)};
        exhibit.solution->path.push_back(state);
    }
    const std::string page = make_player(exhibit);
    EXPECT_LT(page.size(), 5'000'000U);
    EXPECT_GT(page.size(), 2'000'000U) << "there is room for more";
    EXPECT_NE(page.find("\"lastStep\":1000000,"), std::string::npos);
}

}  // namespace
}  // namespace asv::io
