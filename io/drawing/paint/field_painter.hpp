#pragma once

#include <span>

#include "io/drawing/paint/canvas.hpp"
#include "io/drawing/paint/page.hpp"
#include "io/drawing/paint/palette.hpp"
#include "io/drawing/scene/scene.hpp"

namespace asv::io {

/// The colour of something that stands between start and goal.
Colour along_the_way(const Palette& colours, double progress);

/// The path of an ASV: thin among those of all the others, strong when it is the one that came of
/// the search trees.
Stroke path_stroke(const Scene& scene, const Colour& colour);

/// How wide lines are and how large dots, in points of the page, above 0; smaller for more ASVs,
/// larger in the inset. The defaults were chosen by eye.
struct Pen {
    double broom = 1.4;  ///< width
    double dot = 1.7;    ///< radius
};

/// Paints obstacles and every line of the scene, without the field's background.
void paint_scene(Canvas& canvas, const Scene& scene, const Page& page, const Palette& colours);

/// Paints the background with its grid and numbers, the scene, the labels and the border.
void paint_field(Canvas& canvas, const Scene& scene, const Page& page, const Palette& colours);

/// Paints the same for a small picture: no grid, no numbers, no words.
void paint_bare_field(Canvas& canvas, const Scene& scene, const Page& page, const Palette& colours);

/// One chain: its brooms and a dot for each ASV. The points are on the page already.
void paint_chain(Canvas& canvas, const std::vector<geometry::Point>& points, const Pen& pen,
                 const Colour& colour);

/// The same drawn strong, on a rim of the field's colour, its first point with an eye.
void paint_body(Canvas& canvas, const std::vector<geometry::Point>& points, const Palette& colours,
                const Colour& colour);

/// Where the middle of the chain cannot be, on the page: dashed, so that it shows without colours.
void paint_closed(Canvas& canvas, std::span<const geometry::Box> closed, const Palette& colours);

/// A circle with a cross: where a requirement is violated, also without seeing colours.
void paint_violation_mark(Canvas& canvas, const geometry::Point& at, const Palette& colours);

}  // namespace asv::io
