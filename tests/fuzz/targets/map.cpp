#include <algorithm>

#include "geometry/boxes/grid_cover.hpp"
#include "io/map/map_file.hpp"
#include "io/text/parse_error.hpp"
#include "tests/fuzz/targets/promise.hpp"
#include "tests/fuzz/targets/targets.hpp"

namespace asv::fuzz {

namespace {

/// More cells than this are not covered, which would take seconds under sanitizers.
constexpr std::size_t most_cells_to_cover = 10'000;

/// The rectangles hold the occupied cells and no other ones.
void require_covered(const geometry::Grid& grid) {
    std::vector<std::uint8_t> covered(grid.cells.size(), 0);
    for (const geometry::CellRectangle& cells : geometry::cover(grid)) {
        require(cells.left < cells.right && cells.right <= grid.width && cells.bottom < cells.top &&
                    cells.top <= grid.height,
                "a rectangle of cells lies on the grid");
        for (std::size_t y = cells.bottom; y < cells.top; ++y)
            for (std::size_t x = cells.left; x < cells.right; ++x) covered[y * grid.width + x] = 1;
    }
    require(covered == grid.cells, "the rectangles hold exactly the occupied cells");
}

}  // namespace

void map(std::string_view input) {
    try {
        const geometry::Grid grid = io::parse_map(input, "input");
        require(grid.cells.size() == grid.width * grid.height, "a grid has all its cells");
        require(std::all_of(grid.cells.begin(), grid.cells.end(),
                            [](std::uint8_t cell) { return cell <= 1; }),
                "a cell is free or occupied");
        if (grid.cells.size() <= most_cells_to_cover) require_covered(grid);
    } catch (const io::ParseError& error) {
        require_place_in(input, error);
    }
}

}  // namespace asv::fuzz
