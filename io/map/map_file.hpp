#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/boxes/grid_cover.hpp"
#include "io/map/occupied_greys.hpp"

namespace asv::io {

/// Reads a map of occupied cells, one for each pixel or digit, the first line at the top:
/// - a picture, PBM, PGM or PPM (P1 to P6) or PNG (colours as their luma, what is transparent on
///   white): `greys` says which are occupied;
/// - a text grid: lines of digits 0 (free) or 1 (occupied), with or without white space between
///   them; before them perhaps "height H" and "width W", and then the ends of lines mean nothing.
///   `greys` mean nothing there;
/// - a map of the benchmarks for pathfinding on grids (Sturtevant, 2012; MovingAI): "type octile",
///   "height H", "width W", "map", and lines of cells; free are '.', 'G' and 'S'.
/// Which one it is shows in the content. Throws ParseError or ReadError, also for what is no
/// regular file.
geometry::Grid read_map(const std::filesystem::path& file, const OccupiedGreys& greys = {});

/// The same from the content; name stands for the file in messages.
geometry::Grid parse_map(std::string_view content, const std::string& name,
                         const OccupiedGreys& greys = {});

}  // namespace asv::io
