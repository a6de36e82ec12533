#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "geometry/primitives.hpp"
#include "io/benchmark/plot/plot_axis.hpp"
#include "io/benchmark/report.hpp"
#include "io/drawing/paint/canvas.hpp"
#include "io/drawing/paint/palette.hpp"

namespace asv::io {

/// A planner's line in the units of the axes; empty where nothing is known.
struct Curve {
    std::size_t planner = 0;
    std::vector<geometry::Point> line;
    std::vector<geometry::Point> band;  ///< an outline around the line; may be empty
};

/// A field with curves and, beside it, what their colours and marks stand for.
struct CurvePanel {
    std::string title, facts;
    std::string caption;  ///< above the field: what goes up
    std::string name;     ///< below the field: what goes to the right
    Axis x, y;            ///< their places on the page are not looked at
    std::vector<Tick> x_ticks, y_ticks;
    std::vector<Curve> curves;
};

/// The bytes of a page with the panels one below the other. Throws std::runtime_error when cairo
/// fails. Precondition: no more panels than curve_panels_on_page().
std::string draw_curve_panels(const BenchmarkReport& report, const std::string& title,
                              std::span<const CurvePanel> panels, PictureFormat format,
                              Theme theme);

/// How many panels with so many curves each a page has room for; 1 or more.
std::size_t curve_panels_on_page(std::size_t curves);

}  // namespace asv::io
