#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "core/model/path.hpp"
#include "core/model/problem.hpp"
#include "core/search/limits.hpp"
#include "core/search/rng.hpp"
#include "core/search/search_result.hpp"
#include "core/search/trees/nearest.hpp"

namespace asv::adaptor {

/// A row of numbers is a configuration, as in the library.
using Row = std::span<const double>;

/// Where one coordinate of a configuration lies.
struct Range {
    double low = 0, high = 0;
};

/// A problem in planning coordinates and the space of its body, as OMPL needs them: several threads
/// may ask at a time. Angles that wrap need not be unwrapped alike.
class Body {
  public:
    virtual ~Body() = default;

    virtual const core::Problem& problem() const = 0;
    virtual Row start() const = 0;
    virtual Row goal() const = 0;

    /// One for each coordinate. Those of angles that wrap are a full turn long.
    virtual const std::vector<Range>& ranges() const = 0;
    virtual core::WrappingAngles wrapping() const = 0;
    /// How far two configurations may differ along a coordinate, in the metric.
    virtual double extent(std::size_t coordinate) const = 0;
    virtual double distance(Row a, Row b) const = 0;

    /// Draws a configuration of a possible shape, valid where one is found in a bounded number of
    /// tries.
    virtual void sample(core::Rng& rng, std::span<double> row) const = 0;
    /// The row displaced by a normal draw of deviation sigma in the metric along each coordinate.
    virtual void perturb(core::Rng& rng, Row row, double sigma, std::span<double> out) const = 0;

    virtual bool valid(Row row) const = 0;
    /// Is all of the straight motion proven valid?
    virtual bool motion_valid(Row from, Row to) const = 0;
    /// The last row of the straight motion up to which it is proven valid; from itself where
    /// nothing is. Precondition: from is valid.
    virtual std::vector<double> proven_end(Row from, Row to) const = 0;

    /// What the straight motion costs, and what any motion costs at least.
    virtual double cost(Row from, Row to) const = 0;
    virtual double cost_lower_bound(Row from, Row to) const = 0;

    /// The path in primitive steps; none when the deadline comes first. The rows lead from the
    /// start to the goal.
    virtual std::optional<core::Path> steps(const core::Configurations& rows,
                                            core::Clock::time_point deadline) const = 0;
    /// The problem with another start and goal.
    virtual core::Problem problem_between(Row start, Row goal) const = 0;
};

/// Precondition: the problem is one of PlanningFrame.
std::shared_ptr<const Body> make_body(const core::Problem& problem);

/// The row turned by full turns of its angles to be the nearest to the other one.
std::vector<double> unwrapped(Row row, Row other, core::WrappingAngles angles);

}  // namespace asv::adaptor
