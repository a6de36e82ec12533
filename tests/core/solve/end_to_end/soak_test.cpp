// Short runs of everything with everything: whatever comes out has to be right.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iostream>
#include <optional>
#include <stdexcept>

#include <gtest/gtest.h>

#include "core/generate/families.hpp"
#include "core/solve/planner_catalogue.hpp"
#include "core/solve/solve.hpp"
#include "core/validation/validate.hpp"
#include "tests/kit/chains/arms.hpp"
#include "tests/kit/check_results.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using test::for_seeds;
using test::scaled;

constexpr std::size_t most_asvs = 30;

template <class Options>
Options with(const ChainOptions& chain) {
    Options options;
    options.chain = chain;
    return options;
}

/// A problem of a random family with 3 to 30 ASVs, or a random arm; none where the family has no
/// room for so many.
std::optional<Problem> random_problem(Rng& rng) {
    constexpr std::size_t bodies = 9;  // eight families of chains, and arms
    const std::size_t drawn = rng.below(bodies);
    ChainOptions chain;
    chain.asv_count = 3 + rng.below(most_asvs - 2);
    try {
        switch (drawn) {
            case 0:
                return corridor(with<CorridorOptions>(chain), rng);
            case 1:
                return bend(with<BendOptions>(chain), rng);
            case 2:
                return gauntlet(with<GauntletOptions>(chain), rng);
            case 3:
                return rooms(with<RoomsOptions>(chain), rng);
            case 4:
                return maze(with<MazeOptions>(chain), rng);
            case 5:
                return spiral(with<SpiralOptions>(chain), rng);
            case 6:
                return crossing(with<CrossingOptions>(chain), rng);
            case 7:
                return clutter(with<ClutterOptions>(chain), rng);
            default:
                return test::arm_problem(rng);
        }
    } catch (const NoRoom&) {
    } catch (const std::invalid_argument&) {
    }
    return std::nullopt;
}

/// A value of the setting: either of a switch, any of its words, else from a quarter to four times
/// what it is, within its range.
double random_value(const SettingValue& value, Rng& rng) {
    if (value.is_switch() || !value.words.empty())
        return static_cast<double>(rng.below(static_cast<std::size_t>(value.high) + 1));
    const double factor = std::exp2(rng.uniform(-2, 2));
    const double drawn = std::clamp(value.get() * factor, value.low, value.high);
    return value.whole ? std::floor(drawn) : drawn;
}

/// Any planner; each setting is changed with a probability of 0.3, as long as they suit each other
/// and the body.
Planner random_planner(BodyKind body, Rng& rng) {
    const auto names = planner_names();
    while (true) {
        Planner planner = planner_named(names[rng.below(names.size())]);
        for (const Setting& setting : settings(planner))
            if (rng.chance(0.3)) setting.value.set(random_value(setting.value, rng));
        try {
            require_usable(planner, body);
            return planner;
        } catch (const std::invalid_argument&) {
        }
    }
}

SolveOptions random_options(BodyKind body, Rng& rng) {
    SolveOptions options;
    options.planner = random_planner(body, rng);
    options.seed = rng.bits();
    options.max_iterations = 1 + rng.below(1000);
    options.time_limit = 600;  // the iterations end a run, so that it is the same on every machine
    options.optimize = rng.chance(0.5) ? 0 : rng.uniform(0, 0.02);
    options.reverse = rng.chance(0.5);
    options.keep_trees = rng.chance(0.1);
    options.certify_motion = rng.chance(0.2);
    return options;
}

/// The path is valid in all of its motion, costs what is said, and no less than is possible.
void expect_right(const Problem& problem, const SolveResult& result) {
    ASSERT_EQ(result.solution.has_value(), result.status == SolveStatus::solved);
    if (!result.solution) {
        EXPECT_FALSE(result.reason.empty());
        return;
    }
    const double tolerance = problem.requirements.tolerance;
    test::expect_valid(
        validate(problem, *result.solution, {.tolerance = tolerance, .continuous = true}));
    EXPECT_EQ(result.statistics.cost, result.solution->cost);
    EXPECT_GE(result.solution->cost, result.statistics.cost_lower_bound);
}

TEST(Soak, WhateverIsFoundIsRight) {
    std::size_t runs = 0, solved = 0;
    for_seeds(scaled(400), [&](Rng& rng) {
        const auto problem = random_problem(rng);
        if (!problem) return;
        const SolveResult result = solve(*problem, random_options(problem->body_kind(), rng));
        expect_right(*problem, result);
        ++runs;
        if (result.solution) ++solved;
    });
    std::cout << solved << " of " << runs << " solved\n";
    constexpr std::size_t left_to_chance = 3;  // where a slow build makes few runs
    EXPECT_GE(solved + left_to_chance, runs / 4);
}

}  // namespace
}  // namespace asv::core
