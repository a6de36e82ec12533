#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "io/benchmark/plot/curve_data.hpp"
#include "io/benchmark/plot/plot_layout.hpp"
#include "io/benchmark/report.hpp"
#include "io/drawing/paint/canvas.hpp"
#include "io/drawing/paint/palette.hpp"

namespace asv::io {

/// The bytes of a page with the panels one below the other. Throws std::runtime_error when cairo
/// fails. Precondition: no more panels than curve_panels_on_page().
std::string draw_curve_panels(const BenchmarkReport& report, const std::string& title,
                              std::span<const CurvePanel> panels, PictureFormat format, Theme theme,
                              PlotLayout layout);

/// How many panels with so many curves each a page has room for; 1 or more.
std::size_t curve_panels_on_page(std::size_t curves, PlotLayout layout);

}  // namespace asv::io
