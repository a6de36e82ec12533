#include "core/validation/path_tally.hpp"

#include <utility>

#include "core/validation/path_checks.hpp"

namespace asv::core::validation {

PathTally::PathTally(const Requirements& requirements, bool list_offenders, BodyKind body)
    : requirements_(requirements),
      ends_(Check::ends, list_offenders, body),
      steps_(Check::steps, list_offenders, body),
      cost_(Check::cost, list_offenders, body) {}

void PathTally::add_step(State from, State to, double cost, std::size_t state) {
    steps_.add(check_step(from, to, requirements_), state);
    computed_cost_ += cost;
    ++step_count_;
    asv_count_ = from.size();
}

/// Each distance passes through an addition for each ASV and each step behind it, all of which
/// round (Higham, Accuracy and Stability of Numerical Algorithms, 2002, section 4.2).
double PathTally::rounding_of_cost() const {
    constexpr double unit_roundoff = 0x1p-53;
    // Of a distance itself, and of the written sum, in units.
    constexpr std::size_t of_terms = 8;
    const auto roundings = static_cast<double>(step_count_ + asv_count_ + of_terms);
    return roundings * unit_roundoff * computed_cost_;
}

void PathTally::finish(double written_cost, ValidationReport& report) && {
    report.cost = computed_cost_;
    cost_.add(check_cost(written_cost, computed_cost_, rounding_of_cost(), requirements_), 0);
    for (Tally* tally : {&ends_, &steps_, &cost_})
        report.checks.push_back(std::move(*tally).result());
}

void check_path(const Problem& problem, const Solution& solution, const Requirements& requirements,
                bool list_offenders, ValidationReport& report) {
    const Path& path = solution.path;
    const std::size_t last = path.size() - 1;
    PathTally tally(requirements, list_offenders, problem.body_kind());
    tally.add_end(check_end(path.state(0), problem.start, requirements), 0);
    tally.add_end(check_end(path.state(last), problem.goal, requirements), last);
    for (std::size_t i = 1; i <= last; ++i) {
        const State from = path.state(i - 1), to = path.state(i);
        tally.add_step(from, to, step_cost(from, to), i);
    }
    std::move(tally).finish(solution.cost, report);
}

}  // namespace asv::core::validation
