#pragma once

#include <string>
#include <string_view>

#include "geometry/boxes/grid_cover.hpp"
#include "io/map/occupied_greys.hpp"

namespace asv::io {

/// Does the content begin as a PNG picture does?
bool is_png(std::string_view content);

/// A PNG picture as a map: the grey of a pixel is its luma, on white where it is transparent.
/// Throws ParseError.
geometry::Grid parse_png(std::string_view content, const std::string& name,
                         const OccupiedGreys& greys);

}  // namespace asv::io
