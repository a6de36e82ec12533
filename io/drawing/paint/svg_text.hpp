#pragma once

#include <string>
#include <string_view>

#include "geometry/primitives.hpp"
#include "io/drawing/paint/canvas.hpp"

namespace asv::io {

/// The words as an element of an SVG: text that can be selected and searched, which cairo's own
/// text, the outlines of letters, cannot. at is on the base line, at the side that the style
/// aligns to.
std::string svg_text(const geometry::Point& at, std::string_view words, const TextStyle& style);

/// Gives an SVG its accessible name and text.
void describe_svg(std::string& svg, std::string_view title, std::string_view description);

/// Puts the elements into an SVG, in front of everything else that is drawn in it.
void add_svg_texts(std::string& svg, std::string_view texts);

}  // namespace asv::io
