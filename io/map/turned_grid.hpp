#pragma once

#include "geometry/boxes/grid_cover.hpp"

namespace asv::io {

/// Upside down: the first line of the file, which was the upper one, is the lower one.
geometry::Grid flipped(const geometry::Grid& grid);

/// With lines for columns, as a picture is transposed: the first line of the file is the left
/// column, its first cell on top.
geometry::Grid transposed(const geometry::Grid& grid);

}  // namespace asv::io
