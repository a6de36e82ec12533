#pragma once

#include "io/drawing/exhibit.hpp"
#include "io/drawing/paint/canvas.hpp"
#include "io/drawing/paint/page.hpp"
#include "io/drawing/paint/palette.hpp"
#include "io/drawing/scene/scene.hpp"

namespace asv::io {

/// How high the strip below the field has to be.
double strip_height(const Exhibit& exhibit, const Scene& scene);

/// Paints what is below the field: the legend, and for a solution among obstacles the clearance
/// along the way and the place where it is least, enlarged.
void paint_strip(Canvas& canvas, const Exhibit& exhibit, const Scene& scene, const Page& page,
                 const Palette& colours);

}  // namespace asv::io
