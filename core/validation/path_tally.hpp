#pragma once

#include <cstddef>
#include <utility>

#include "core/model/path.hpp"
#include "core/model/problem.hpp"
#include "core/validation/finding.hpp"
#include "core/validation/state_checks.hpp"

namespace asv::core::validation {

/// Adds up the three checks of every body that concern the path as a whole: ends, steps, cost.
class PathTally {
  public:
    PathTally(const Requirements& requirements, bool list_offenders, BodyKind body);

    void add_end(Finding finding, std::size_t state) { ends_.add(std::move(finding), state); }

    /// cost: of the step, in the unit of the body.
    void add_step(State from, State to, double cost, std::size_t state);

    /// Fills in the computed cost and appends the checks.
    void finish(double written_cost, ValidationReport& report) &&;

  private:
    double rounding_of_cost() const;

    const Requirements& requirements_;
    Tally ends_, steps_, cost_;
    double computed_cost_ = 0;
    std::size_t step_count_ = 0, asv_count_ = 0;
};

/// The three checks where the cost is the distance moved.
void check_path(const Problem& problem, const Solution& solution, const Requirements& requirements,
                bool list_offenders, ValidationReport& report);

}  // namespace asv::core::validation
