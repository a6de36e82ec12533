#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "geometry/primitives.hpp"
#include "io/benchmark/plot/plot_axis.hpp"
#include "io/benchmark/report.hpp"

/// The curves of a benchmark, for pictures and for pages.

namespace asv::io {

/// A planner's line in the units of the axes; empty where nothing is known.
struct Curve {
    std::size_t planner = 0;
    std::vector<geometry::Point> line;
    std::vector<geometry::Point> band;  ///< an outline around the line; may be empty
};

/// What the numbers of an axis are.
enum class Quantity {
    number,
    seconds,
    share  ///< 0 to 1
};

/// A field with curves and what is written around it.
struct CurvePanel {
    std::string title, facts;
    std::string caption;  ///< above the field: what goes up
    std::string name;     ///< below the field: what goes to the right
    Axis x, y;            ///< their places on the page are not looked at
    Quantity x_is = Quantity::number, y_is = Quantity::number;
    std::vector<Tick> x_ticks, y_ticks;
    std::vector<Curve> curves;
};

/// No logarithmic axis begins at 0 seconds.
inline constexpr double shortest_time = 1e-6;

/// Shares go up in the panel, with room for a line along the top to be seen.
void set_shares(CurvePanel& panel);

/// Runs of a benchmark that stand one after the other.
using Runs = std::span<const core::BenchmarkRun>;

/// The runs of each problem in each direction. Precondition: they are by problem and direction.
std::vector<Runs> tasks_of(Runs runs);

/// "7ASV, reversed": problem and direction of the task.
std::string task_title(const core::BenchmarkPlan& plan, Runs task);

/// Which share of the runs of each planner is solved after which time. Precondition: there are
/// runs.
CurvePanel solved_panel(const core::BenchmarkPlan& plan, Runs runs);

/// The cost of the best path over the time of the runs: the median of each planner as a line, the
/// quartiles as a band, both from the time on at which enough runs have a path. Precondition: the
/// runs are of one problem in one direction, by planner, and there are some.
CurvePanel cost_panel(const core::BenchmarkPlan& plan, Runs task);

/// Performance profiles: on which share of problems and directions the median time of each planner
/// is within a factor of the best one's.
CurvePanel profile_panel(const BenchmarkReport& report);

}  // namespace asv::io
