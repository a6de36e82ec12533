#include "core/search/region_bias.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "core/model/problem.hpp"
#include "tests/kit/toy_spaces.hpp"

namespace asv::core {
namespace {

using test::PointSpace;
using test::Row;

TEST(RegionBias, FollowsATreeAlongTheWayAndNotThroughWalls) {
    // The way goes right and comes back on the other side of a wall.
    std::vector<Point> stops;
    for (int i = 0; i <= 10; ++i) stops.push_back({0.1 * i, 0.4});
    for (int i = 10; i >= 0; --i) stops.push_back({0.1 * i, 0.5});
    RegionBias bias(stops);
    PointSpace space({});
    Tree tree(space.make_index());
    const auto position = [](std::span<const double> row) { return Point{row[0], row[1]}; };
    std::uint32_t node = tree.add(Row{0, 0.4}, Tree::none);
    node = tree.add(Row{0.1, 0.44}, node);
    node = tree.add(Row{0.2, 0.46}, node);
    bias.follow(tree, position);
    Rng rng(1);
    for (int i = 0; i < 50; ++i) {
        const std::size_t region = bias.region(rng);
        EXPECT_LE(region, 2U) << "nearer to the way back, but far along it";
        EXPECT_EQ(bias.node_at(region, rng), region);
        EXPECT_EQ(bias.ahead(region, rng).y, 0.4);
    }
    EXPECT_EQ(bias.in_vain(), 50U);
    for (int i = 3; i <= 10; ++i) node = tree.add(Row{0.1 * i, 0.45}, node);
    tree.add(Row{1, 0.52}, node);
    bias.follow(tree, position);
    EXPECT_EQ(bias.in_vain(), 0U);
    std::size_t farthest = 0;
    for (int i = 0; i < 50; ++i) farthest = std::max(farthest, bias.region(rng));
    EXPECT_EQ(farthest, 11U) << "the first stop of the way back";
}

}  // namespace
}  // namespace asv::core
