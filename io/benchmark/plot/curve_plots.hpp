#pragma once

#include <string>

#include "io/benchmark/plot/plot_layout.hpp"
#include "io/benchmark/report.hpp"
#include "io/drawing/paint/canvas.hpp"
#include "io/drawing/paint/palette.hpp"

namespace asv::io {

/// The bytes of a picture of performance profiles: on which share of problems and directions the
/// median time of each planner is within a factor of the best one's. Throws std::runtime_error when
/// cairo fails.
std::string draw_profiles(const BenchmarkReport& report, PictureFormat format, Theme theme,
                          PlotLayout layout = PlotLayout::wide);

/// The bytes of a picture of the cost of the best path over the time of the runs: for each problem
/// and direction the median of each planner as a line, the quartiles as a band, both from the time
/// on at which enough runs have a path. With more problems than fit on a page, the first ones.
/// Throws std::runtime_error when cairo fails.
std::string draw_costs_over_time(const BenchmarkReport& report, PictureFormat format, Theme theme,
                                 PlotLayout layout = PlotLayout::wide);

/// The bytes of a picture of median time and success over the report's parameter of the problems.
/// Throws std::runtime_error when cairo fails.
std::string draw_parameter(const BenchmarkReport& report, PictureFormat format, Theme theme,
                           PlotLayout layout = PlotLayout::wide);

}  // namespace asv::io
