#pragma once

#include <string>
#include <string_view>

#include "geometry/boxes/grid_cover.hpp"
#include "io/map/occupied_greys.hpp"

namespace asv::io {

/// Is it one of the pictures of Netpbm, P1 to P6?
bool is_anymap(std::string_view content);

/// A picture of Netpbm as a map: PBM (P1, P4; 1 is black), PGM (P2, P5) or PPM (P3, P6, as its
/// luma). Throws ParseError.
geometry::Grid parse_anymap(std::string_view content, const std::string& name,
                            const OccupiedGreys& greys);

}  // namespace asv::io
