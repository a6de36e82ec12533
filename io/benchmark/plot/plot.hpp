#pragma once

#include <string>

#include "io/benchmark/plot/plot_layout.hpp"
#include "io/benchmark/report.hpp"
#include "io/drawing/paint/canvas.hpp"
#include "io/drawing/paint/palette.hpp"

namespace asv::io {

/// The bytes of a picture of the benchmark. For each problem: which share of the runs is solved
/// after which time, a curve for each planner; and the costs of their paths over the lower bound, a
/// dot for each run, with quartiles and median. Planners are told apart by colour and by mark,
/// directions by full and broken lines, full and hollow marks. With more problems than fit on a
/// page, all of them together. Throws std::runtime_error when cairo fails.
std::string draw_benchmark(const BenchmarkReport& report, PictureFormat format, Theme theme,
                           PlotLayout layout = PlotLayout::wide);

}  // namespace asv::io
