#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "io/benchmark/report.hpp"

namespace asv::io {

/// What a plot shows of one planner in one direction.
struct PlotSeries {
    std::size_t planner = 0;
    core::Direction direction = core::Direction::forward;
    std::size_t runs = 0;
    std::vector<double> times;  ///< seconds to the first path of the solved runs, ascending
    std::vector<double> costs;  ///< of their paths, over the lower bound where relative; ascending
};

/// One problem, or all of them together.
struct PlotPanel {
    std::string title, facts;
    bool relative = true;  ///< are the costs over the lower bound, which is known of all runs?
    std::vector<PlotSeries> series;
};

/// One panel for each problem; a single one where there are more than `most`.
std::vector<PlotPanel> plot_panels(const BenchmarkReport& report, std::size_t most);

}  // namespace asv::io
