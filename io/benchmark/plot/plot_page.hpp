#pragma once

#include <string>

#include "geometry/primitives.hpp"
#include "io/benchmark/plot/plot_axis.hpp"
#include "io/benchmark/plot/plot_layout.hpp"
#include "io/benchmark/report.hpp"
#include "io/drawing/paint/canvas.hpp"
#include "io/drawing/paint/palette.hpp"

/// What the pages of all plots have in common.

namespace asv::io {

// In points. In a column of 8 cm, on a page of 360, letters are 7 to 9 points high.
inline constexpr double text_size = 13.5, tick_size = 11.5;
/// Above the field of a panel, for its title and caption; below it, for the ticks and their name.
inline constexpr double panel_top = 54, panel_bottom = 58;
inline constexpr double greatest_header = 104, below_panels = 16;
/// An image of cairo has no more than 32767 pixels: two for each point.
inline constexpr double greatest_page = 16000;

/// Where things are across the page of a layout.
struct PageMeasures {
    double width;
    double words;        ///< where titles and captions begin
    double left, right;  ///< of what has ticks to its left, and where everything ends
};
PageMeasures page_measures(PlotLayout layout);

/// Of what is above the first panel.
double header_height(const BenchmarkReport& report, PlotLayout layout);

/// What spoilt the times; in a wide layout the title and how the benchmark was run as well.
void draw_header(Canvas& canvas, const Palette& colours, const BenchmarkReport& report,
                 const std::string& title, PlotLayout layout);

/// Title and, in a wide layout, facts of a panel that begins at this height of the page.
void draw_panel_title(Canvas& canvas, const Palette& colours, const std::string& title,
                      const std::string& facts, double top, PlotLayout layout);

/// A line across the field for each tick, its label below the field or to the left of it.
void draw_upright_ticks(Canvas& canvas, const Palette& colours, const geometry::Box& field,
                        const Axis& axis, const std::vector<Tick>& ticks);
void draw_level_ticks(Canvas& canvas, const Palette& colours, const geometry::Box& field,
                      const Axis& axis, const std::vector<Tick>& ticks);

/// As much of the text as is no wider, with an ellipsis where something is missing.
std::string shortened(Canvas& canvas, std::string text, const TextStyle& style, double width);

}  // namespace asv::io
