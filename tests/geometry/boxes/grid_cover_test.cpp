#include "geometry/boxes/grid_cover.hpp"

#include <gtest/gtest.h>

#include "tests/kit/random.hpp"

namespace asv::geometry {
namespace {

Grid random_grid(test::Random& random) {
    Grid grid{1 + random.below(12), 1 + random.below(12)};
    const auto density = random.below(11);
    for (std::size_t i = 0; i < grid.width * grid.height; ++i)
        grid.cells.push_back(random.below(10) < density);
    return grid;
}

bool holds(const CellRectangle& r, std::size_t x, std::size_t y) {
    return r.left <= x && x < r.right && r.bottom <= y && y < r.top;
}

bool together(const std::vector<CellRectangle>& cover, std::size_t x, std::size_t y,
              std::size_t other_x, std::size_t other_y) {
    for (const CellRectangle& r : cover)
        if (holds(r, x, y) && holds(r, other_x, other_y)) return true;
    return false;
}

TEST(GridCover, IsExactlyTheOccupiedCellsAndKeepsNeighboursTogether) {
    for (std::uint64_t seed = 1; seed <= 3000; ++seed) {
        test::Random random(seed);
        const Grid grid = random_grid(random);
        const auto rectangles = cover(grid);
        for (std::size_t y = 0; y < grid.height; ++y) {
            for (std::size_t x = 0; x < grid.width; ++x) {
                const bool occupied = grid.occupied(x, y);
                ASSERT_EQ(together(rectangles, x, y, x, y), occupied) << "seed " << seed;
                if (occupied && x + 1 < grid.width && grid.occupied(x + 1, y)) {
                    ASSERT_TRUE(together(rectangles, x, y, x + 1, y)) << "seed " << seed;
                }
                if (occupied && y + 1 < grid.height && grid.occupied(x, y + 1)) {
                    ASSERT_TRUE(together(rectangles, x, y, x, y + 1)) << "seed " << seed;
                }
            }
        }
        for (const CellRectangle& r : rectangles) {
            ASSERT_LE(r.right, grid.width) << "seed " << seed;
            ASSERT_LE(r.top, grid.height) << "seed " << seed;
        }
    }
}

TEST(GridCover, TakesFewRectangles) {
    EXPECT_TRUE(cover({4, 3, std::vector<std::uint8_t>(12, 0)}).empty());
    EXPECT_EQ(cover({4, 3, std::vector<std::uint8_t>(12, 1)}),
              (std::vector<CellRectangle>{{0, 0, 4, 3}}));
    // An L: its arms share the corner.
    EXPECT_EQ(cover({2, 2, {1, 1, 1, 0}}),
              (std::vector<CellRectangle>{{0, 0, 2, 1}, {0, 0, 1, 2}}));
    // Cells that share a corner alone.
    EXPECT_EQ(cover({2, 2, {1, 0, 0, 1}}),
              (std::vector<CellRectangle>{{0, 0, 1, 1}, {1, 1, 2, 2}}));
}

}  // namespace
}  // namespace asv::geometry
