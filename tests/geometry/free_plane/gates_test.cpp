#include "geometry/free_plane/gates.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include <gtest/gtest.h>

namespace asv::geometry {
namespace {

constexpr Box square{{0, 0}, {1, 1}};

std::vector<Box> gates(std::vector<Point> way, std::vector<Box> boxes) {
    std::vector<Box> gaps;
    for (const Gate& gate : gates_on_way(way, boxes, square)) gaps.push_back(gate.gap);
    return gaps;
}

TEST(Gates, AreTheRectanglesBetweenBoxesThatAWayCrosses) {
    const std::vector<Box> wall{{{0.5, 0}, {0.6, 0.3}}, {{0.5, 0.4}, {0.6, 1}}};
    const std::vector<Box> door{{{0.5, 0.3}, {0.6, 0.4}}};
    EXPECT_EQ(gates({{0.1, 0.35}, {0.9, 0.35}}, wall), door);
    EXPECT_TRUE(gates({{0.1, 0.35}, {0.4, 0.35}, {0.4, 0.2}}, wall).empty());
    // A shortest way bends at the corner of a box.
    EXPECT_EQ(gates({{0.1, 0.35}, {0.5, 0.3}, {0.6, 0.3}, {0.9, 0.35}}, wall), door);
}

TEST(Gates, LeadFromCornerToCorner) {
    const Box below{{0.2, 0.2}, {0.4, 0.4}}, right_above{{0.5, 0.5}, {0.7, 0.7}};
    const Box left_above{{0.05, 0.5}, {0.15, 0.7}};
    const std::vector<Point> rising{{0.1, 0.35}, {0.9, 0.36}}, crossing{{0.3, 0.6}, {0.6, 0.3}};
    const auto found = gates(crossing, {below, right_above});
    EXPECT_NE(std::find(found.begin(), found.end(), Box{{0.4, 0.4}, {0.5, 0.5}}), found.end());
    const auto falling = gates({{0.1, 0.3}, {0.22, 0.6}}, {below, left_above});
    EXPECT_NE(std::find(falling.begin(), falling.end(), Box{{0.15, 0.4}, {0.2, 0.5}}),
              falling.end());
}

TEST(Gates, LieBesideTheBorderToo) {
    const std::vector<Box> box{{{0.4, 0.2}, {0.6, 1}}};
    const std::vector<Box> below{{{0.4, 0}, {0.6, 0.2}}};
    EXPECT_EQ(gates({{0.1, 0.1}, {0.9, 0.1}}, box), below);
    const std::vector<Point> way{{0.1, 0.1}, {0.9, 0.1}};
    const std::size_t lower_border = box.size() + 2;
    EXPECT_EQ(gates_on_way(way, box, square).at(0).sides,
              (std::array<std::size_t, 2>{0, lower_border}));
}

TEST(Gates, AreNotWhereAThirdBoxStandsBetween) {
    const std::vector<Box> three{
        {{0.4, 0}, {0.6, 0.2}}, {{0.4, 0.8}, {0.6, 1}}, {{0.45, 0.4}, {0.55, 0.6}}};
    const std::vector<Box> upper{{{0.45, 0.6}, {0.55, 0.8}}};
    EXPECT_EQ(gates({{0.1, 0.7}, {0.9, 0.7}}, three), upper);
}

}  // namespace
}  // namespace asv::geometry
