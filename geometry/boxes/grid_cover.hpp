#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace asv::geometry {

/// A field of square cells, row by row, row 0 at the bottom; 1 is occupied, 0 is free.
struct Grid {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<std::uint8_t> cells = {};  ///< width * height

    bool occupied(std::size_t x, std::size_t y) const { return cells[y * width + x] != 0; }
};

/// The cells [left, right) x [bottom, top).
struct CellRectangle {
    std::size_t left = 0, bottom = 0, right = 0, top = 0;
    friend bool operator==(const CellRectangle&, const CellRectangle&) = default;
};

/// Few rectangles whose union is exactly the occupied cells. They overlap rather than abut: every
/// two occupied cells side by side lie together in one of them, so that rectangles that are shrunk
/// a little on each side leave no slit between them. (Cells that share a corner alone stay apart.)
///
/// Greedy: cell by cell from the bottom left, each cell, and each pair of neighbours, that no
/// rectangle holds yet gets the larger of two maximal ones: as wide as possible and then as high,
/// or the other way round. Near the least number, which is hard to find (Culberson and Reckhow,
/// 1994). O(rectangles * cells) at worst, in practice a few passes over the cells.
/// Ends early, with one rectangle more than `most`, where more than that would be needed.
/// Precondition: grid.cells.size() == grid.width * grid.height.
std::vector<CellRectangle> cover(const Grid& grid,
                                 std::size_t most = std::numeric_limits<std::size_t>::max());

}  // namespace asv::geometry
