#include "core/benchmark/machine_unit.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "core/benchmark/scalar_chain.hpp"
#include "core/benchmark/statistics/statistics.hpp"
#include "core/model/requirements.hpp"
#include "core/search/rng.hpp"

namespace asv::core {

namespace {

using geometry::Box;
using geometry::Point;

constexpr std::size_t asvs = 7;
constexpr std::size_t state_count = 512;
constexpr std::size_t rounds = 9;
constexpr std::size_t checks_per_round = 40 * state_count;

/// The rooms of testcases/7ASV.txt, so that the program needs no file for its unit. Changing
/// anything here changes the unit.
constexpr std::array<Box, 7> rooms{{{{0.28, 0}, {0.37, 0.24}},
                                    {{0.28, 0.274}, {0.37, 0.56}},
                                    {{0.28, 0.59}, {0.37, 1}},
                                    {{0.62, 0.16}, {0.7, 0.78}},
                                    {{0.62, 0.84}, {0.7, 1}},
                                    {{0.45, 0.22}, {0.62, 0.27}},
                                    {{0.7, 0.62}, {0.88, 0.67}}}};

using State = std::array<double, asvs + 1>;  ///< x, y, headings of the brooms

batch::ChainLimits limits_of_chain() {
    const Requirements requirements;
    batch::ChainLimits limits;
    limits.link = requirements.broom_length;
    limits.bounds = requirements.bounds;
    limits.min_area = requirements.min_area(asvs);
    limits.min_turn.assign(asvs - 2, 0.0);
    return limits;
}

/// Somewhere in the square, its total turn split over the joints by exponential draws.
State random_state(Rng& rng) {
    State state{rng.uniform(), rng.uniform(), rng.uniform(-std::numbers::pi, std::numbers::pi)};
    std::array<double, asvs - 2> turns;
    double sum = rng.uniform();
    for (double& turn : turns) sum += turn = -std::log(1 - rng.uniform());
    const double total = rng.uniform(0, 2 * std::numbers::pi);
    for (std::size_t k = 0; k < turns.size(); ++k)
        state[3 + k] = state[2 + k] + turns[k] * total / sum;
    return state;
}

std::vector<State> valid_states(const batch::ChainLimits& limits) {
    Rng rng(7);
    std::array<Point, asvs> scratch;
    std::vector<State> states;
    while (states.size() < state_count) {
        const State state = random_state(rng);
        if (reference::valid(state, limits, rooms, scratch)) states.push_back(state);
    }
    return states;
}

double seconds_of_round(const std::vector<State>& states, const batch::ChainLimits& limits) {
    std::array<Point, asvs> scratch;
    std::size_t valid = 0;
    const auto begin = std::chrono::steady_clock::now();
    for (std::size_t pass = 0; pass < checks_per_round / state_count; ++pass)
        for (const State& state : states)
            valid += reference::valid(state, limits, rooms, scratch) ? 1U : 0U;
    const auto end = std::chrono::steady_clock::now();
    // The count is used, so that no compiler leaves the loop out.
    if (valid != checks_per_round) throw std::logic_error("a valid state is not valid any more");
    return std::chrono::duration<double>(end - begin).count();
}

}  // namespace

double seconds_per_million_checks() {
    const batch::ChainLimits limits = limits_of_chain();
    const std::vector<State> states = valid_states(limits);
    std::vector<double> seconds;
    for (std::size_t round = 0; round < rounds; ++round)
        seconds.push_back(seconds_of_round(states, limits));
    return statistics::spread_of(std::move(seconds)).median * 1e6 /
           static_cast<double>(checks_per_round);
}

}  // namespace asv::core
