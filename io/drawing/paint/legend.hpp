#pragma once

#include <functional>
#include <string>
#include <vector>

#include "io/drawing/paint/canvas.hpp"
#include "io/drawing/paint/page.hpp"
#include "io/drawing/paint/palette.hpp"
#include "io/drawing/scene/scene.hpp"

namespace asv::io {

/// One entry of the legend: a small drawing and words.
struct LegendEntry {
    std::string words;
    std::function<void(Canvas&, const geometry::Point&)>
        draw;           ///< at is the left end of its middle line
    double width = 30;  ///< of the drawing in points; most are this wide
};

/// What the scene has, in the order in which it is told. The palette has to outlive the entries.
std::vector<LegendEntry> legend(const Scene& scene, const Palette& colours);

/// How high the lines of the entries are, set within the width.
double legend_height(Canvas& canvas, const std::vector<LegendEntry>& entries, double width);

void paint_legend(Canvas& canvas, const std::vector<LegendEntry>& entries,
                  const geometry::Point& corner, double width, const Palette& colours);

}  // namespace asv::io
