#include "core/benchmark/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

namespace asv::core {

namespace {

using Task = std::pair<std::size_t, Direction>;

/// What one planner measured, by task and seed.
using Measured = std::map<Task, std::map<std::uint64_t, double>>;

/// The values of two planners on one task, those of one pair at the same place.
struct TaskPairs {
    std::vector<double> first, second;
};

std::optional<double> value_of(const BenchmarkRun& run, Measure measure, double time_limit) {
    // Nothing is measured below it; ratios and logarithms of nothing at all would not be finite.
    constexpr double least = 1e-9;
    if (measure == Measure::time)
        return std::max(least,
                        run.solved() ? std::min(run.spent.time_to_first, time_limit) : time_limit);
    if (!run.solved()) return std::nullopt;
    return std::max(least, run.spent.cost);
}

/// By planner.
std::vector<Measured> measured(const BenchmarkPlan& plan, std::span<const BenchmarkRun> runs,
                               Measure measure) {
    std::vector<Measured> result(plan.planners.size());
    for (const BenchmarkRun& run : runs) {
        const auto& [problem, planner, direction, seed] = run.place;
        if (const auto value = value_of(run, measure, plan.time_limit))
            result[planner][{problem, direction}][seed] = *value;
    }
    return result;
}

std::vector<TaskPairs> pairs_of(const Measured& first, const Measured& second) {
    std::vector<TaskPairs> tasks;
    for (const auto& [task, values] : first) {
        const auto others = second.find(task);
        if (others == second.end()) continue;
        TaskPairs pairs;
        for (const auto& [seed, value] : values) {
            const auto other = others->second.find(seed);
            if (other == others->second.end()) continue;
            pairs.first.push_back(value);
            pairs.second.push_back(other->second);
        }
        if (!pairs.first.empty()) tasks.push_back(std::move(pairs));
    }
    return tasks;
}

void compare_tasks(Comparison& comparison, const std::vector<TaskPairs>& tasks) {
    double chances = 0;
    for (const TaskPairs& pairs : tasks) {
        chances += statistics::chance_of_less(pairs.first, pairs.second);
        const double first = statistics::spread_of(pairs.first).median;
        const double second = statistics::spread_of(pairs.second).median;
        comparison.first_better += first < second ? 1U : 0U;
        comparison.second_better += second < first ? 1U : 0U;
    }
    comparison.chance_of_less = chances / static_cast<double>(tasks.size());
}

void compare_ratios(Comparison& comparison, const std::vector<TaskPairs>& tasks) {
    std::vector<double> logarithms;
    statistics::CensoredSample ratios;
    for (const auto& [first, second] : tasks)
        for (std::size_t i = 0; i < first.size(); ++i) {
            // Two logarithms: so that changing places changes the sign alone, and ties stay ties.
            logarithms.push_back(std::log(first[i]) - std::log(second[i]));
            ratios.known.push_back(first[i] / second[i]);
        }
    std::sort(ratios.known.begin(), ratios.known.end());
    comparison.test = statistics::signed_rank_test(logarithms);
    comparison.ratio = statistics::quantile(ratios.known, 0.5);
    const statistics::CensoredInterval interval = statistics::median_interval(ratios);
    comparison.ratio_interval = {interval.low.value, interval.high.value};
}

/// Corrected together: whoever reads the table looks at all of its rows.
void correct_together(std::vector<Comparison>& comparisons) {
    std::vector<double> p;
    for (const Comparison& comparison : comparisons) p.push_back(comparison.test.p);
    const std::vector<double> corrected = statistics::holm(p);
    for (std::size_t i = 0; i < comparisons.size(); ++i) comparisons[i].corrected_p = corrected[i];
}

}  // namespace

std::vector<Comparison> compare_planners(const BenchmarkPlan& plan,
                                         std::span<const BenchmarkRun> runs) {
    std::vector<Comparison> comparisons;
    for (const Measure measure : {Measure::time, Measure::cost}) {
        const std::vector<Measured> values = measured(plan, runs, measure);
        for (std::size_t first = 0; first < values.size(); ++first)
            for (std::size_t second = first + 1; second < values.size(); ++second) {
                const auto tasks = pairs_of(values[first], values[second]);
                if (tasks.empty()) continue;
                Comparison comparison{measure, first, second};
                compare_tasks(comparison, tasks);
                compare_ratios(comparison, tasks);
                comparisons.push_back(comparison);
            }
    }
    correct_together(comparisons);
    return comparisons;
}

}  // namespace asv::core
