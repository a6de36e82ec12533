#include "io/map/turned_grid.hpp"

namespace asv::io {

namespace {

using geometry::Grid;

/// from(x, y) is the cell that comes to x, y.
template <class From>
Grid turned_grid(const Grid& grid, std::size_t width, std::size_t height, const From& from) {
    Grid result{width, height};
    result.cells.reserve(grid.cells.size());
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x) result.cells.push_back(from(x, y));
    return result;
}

}  // namespace

Grid flipped(const Grid& grid) {
    return turned_grid(grid, grid.width, grid.height, [&](std::size_t x, std::size_t y) {
        return grid.cells[(grid.height - 1 - y) * grid.width + x];
    });
}

Grid transposed(const Grid& grid) {
    const std::size_t top = grid.height - 1, right = grid.width - 1;
    return turned_grid(grid, grid.height, grid.width, [&](std::size_t x, std::size_t y) {
        return grid.cells[(top - x) * grid.width + right - y];
    });
}

}  // namespace asv::io
