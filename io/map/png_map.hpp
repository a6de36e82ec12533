#pragma once

#include <string>
#include <string_view>

#include "geometry/boxes/grid_cover.hpp"

namespace asv::io {

/// Does the content begin as a PNG picture does?
bool is_png(std::string_view content);

/// A PNG picture as a map: a pixel whose luma, on white where it is transparent, is at most
/// `threshold` of 255 is occupied. Throws ParseError.
geometry::Grid parse_png(std::string_view content, const std::string& name, double threshold);

}  // namespace asv::io
