#include "core/bounds/passages/place_grid.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

namespace asv::core {
namespace {

using geometry::Box;

const Box square{{0, 0}, {1, 1}};
const std::vector<Box> walls{{{0.2, -1}, {0.3, 0.6}}, {{0.3, 0.4}, {2, 0.6}}};

TEST(PlaceGrid, CutsAlongTheSidesOfBoxes) {
    const PlaceGrid grid(square, walls, 5);
    ASSERT_EQ(grid.size(), 9u);
    EXPECT_EQ(grid.box(0), (Box{{0, 0}, {0.2, 0.4}}));
    EXPECT_EQ(grid.box(grid.place_at({0.25, 0.5})), (Box{{0.2, 0.4}, {0.3, 0.6}}));
    EXPECT_EQ(grid.place_at({0, 0}), 0u);
    EXPECT_EQ(grid.place_at({1, 1}), grid.size() - 1);
}

TEST(PlaceGrid, HasNoPlaceThatIsLongerThanTold) {
    const PlaceGrid grid(square, walls, 0.15);
    for (std::size_t place = 0; place < grid.size(); ++place) {
        const auto& [low, high] = grid.box(place);
        EXPECT_LE(std::max(high.x - low.x, high.y - low.y), 0.15 + 1e-12);
        EXPECT_EQ(grid.place_at({(low.x + high.x) / 2, (low.y + high.y) / 2}), place);
    }
}

TEST(PlaceGrid, NeighboursShareASide) {
    const PlaceGrid grid(square, walls, 0.3);
    for (std::size_t place = 0; place < grid.size(); ++place) {
        const std::vector<std::size_t> beside = grid.neighbours(place);
        for (std::size_t other = 0; other < grid.size(); ++other) {
            const Box a = grid.box(place), b = grid.box(other);
            const bool in_row = a.low.y == b.low.y && (a.high.x == b.low.x || b.high.x == a.low.x);
            const bool in_column =
                a.low.x == b.low.x && (a.high.y == b.low.y || b.high.y == a.low.y);
            const bool found = std::ranges::find(beside, other) != beside.end();
            EXPECT_EQ(found, in_row || in_column);
        }
    }
}

}  // namespace
}  // namespace asv::core
