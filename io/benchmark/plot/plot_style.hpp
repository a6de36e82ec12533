#pragma once

#include <cstddef>

#include "geometry/primitives.hpp"
#include "io/drawing/paint/canvas.hpp"
#include "io/drawing/paint/palette.hpp"

/// How planners are told apart in a plot.

namespace asv::io {

/// Colour of the planner: hues of Okabe and Ito at a contrast of at least 3 on the page.
Colour planner_colour(std::size_t planner, Theme theme);

/// Its mark, another one for each of seven in a row; hollow ones are filled with the page's colour.
void draw_mark(Canvas& canvas, std::size_t planner, const geometry::Point& at, double radius,
               const Colour& colour, bool hollow, const Colour& page);

}  // namespace asv::io
