#pragma once

#include "io/drawing/paint/canvas.hpp"
#include "io/drawing/paint/page.hpp"
#include "io/drawing/paint/palette.hpp"
#include "io/drawing/scene/scene.hpp"

namespace asv::io {

/// Paints the obstacles as one shape: where they touch or overlap, their union is outlined. More
/// than a drawing can hold become pixels without an outline.
void paint_obstacles(Canvas& canvas, const Scene& scene, const Page& page, const Palette& colours);

/// Paints the number of each obstacle in its middle, where there are few of them: in those that
/// have room for it and that no other obstacle touches there.
void paint_obstacle_numbers(Canvas& canvas, const Scene& scene, const Page& page,
                            const Palette& colours);

}  // namespace asv::io
