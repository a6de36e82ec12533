#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/boxes/box_tree.hpp"
#include "geometry/primitives.hpp"

/// The data behind BoxIndex where boxes are many and small; use that class instead.

namespace asv::geometry::detail {

/// The centres of up to 31 boxes in one line of cache, in steps of a 255th of the cell from its low
/// corner, rounded to the nearest. Lanes without a box hold zeros. Where the cell goes on in a
/// further line, the last lane holds something else.
struct alignas(64) DustLine {
    static constexpr std::uint32_t width = 32;
    static constexpr std::uint32_t max_boxes = width - 1;
    static constexpr double steps = 255;
    std::array<std::uint8_t, width> x, y;

    bool goes_on() const { return x[max_boxes] != 0; }
    void set_goes_on() { x[max_boxes] = 1; }
};

/// A box that lies in one line of cache.
struct alignas(32) WholeBox : Box {};

/// Boxes much smaller than the distances between them, in the cells of a grid: two bytes for each
/// are all that a search looks at of those that are not near, and the cells along a segment are
/// known without looking at anything. Empty (no lines) where the boxes are not like that.
struct DustGrid {
    Point low{};                    ///< the lower left corner of cell 0
    double cell = 0;                ///< side
    double half_x = 0, half_y = 0;  ///< no box reaches farther from its centre
    std::uint32_t columns = 0, rows = 0;
    std::vector<DustLine> lines;         ///< of the cells row by row, then the further ones
    std::vector<std::uint32_t> further;  ///< for each line the cell's next one; 0 if there is none
    std::vector<std::uint32_t> first;    ///< for each line its first box, and the end
    std::vector<WholeBox> boxes;         ///< in the order of the cells
    BoxTree others;                      ///< the boxes that are too large for the grid

    bool empty() const { return lines.empty(); }
};

/// Time O(m). Preconditions: as for build_box_tree.
DustGrid build_dust_grid(std::span<const Box> boxes);

}  // namespace asv::geometry::detail
