#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "core/generate/families.hpp"
#include "core/shapes/flat_chain.hpp"

namespace asv::core {
namespace {

// What the options say must show in the problem.

TEST(Corridor, HasTheHeightLengthAndLevelAskedFor) {
    CorridorOptions options;
    options.chain.asv_count = 7;
    options.height.factor = 1.1;
    options.length = 0.31;
    options.level = 0.4;
    Rng rng(2);
    const Problem problem = corridor(options, rng);
    ASSERT_EQ(problem.obstacles.size(), 2u);
    const Box &below = problem.obstacles[0], &above = problem.obstacles[1];
    EXPECT_NEAR(above.low.y - below.high.y, 1.1 * min_flat_height(7), 3e-9);
    EXPECT_NEAR((above.low.y + below.high.y) / 2, 0.4, 3e-9);
    EXPECT_NEAR(below.high.x - below.low.x, 0.31, 3e-9);
    EXPECT_EQ(below.low.y, 0);
    EXPECT_EQ(above.high.y, 1);
    for (const Point& point : problem.start) EXPECT_LT(point.x, below.low.x);
    for (const Point& point : problem.goal) EXPECT_GT(point.x, below.high.x);
}

TEST(Corridor, IsLongerThanTheChainWhereThatFits) {
    for (std::size_t n = 4; n <= 10; ++n) {
        CorridorOptions options;
        options.chain.asv_count = n;
        Rng rng(n);
        const Box block = corridor(options, rng).obstacles.front();
        EXPECT_GT(block.high.x - block.low.x, 0.05 * static_cast<double>(n - 1));
    }
}

TEST(Gauntlet, NeighbouringCorridorsAreFarApart) {
    GauntletOptions options;
    options.chain.asv_count = 5;
    options.walls = 4;
    options.min_offset = 0.3;
    Rng rng(3);
    const Problem problem = gauntlet(options, rng);
    ASSERT_EQ(problem.obstacles.size(), 8u);
    for (std::size_t i = 0; i + 2 < 8; i += 2) {
        const double offset = problem.obstacles[i].high.y - problem.obstacles[i + 2].high.y;
        EXPECT_GE(std::abs(offset), 0.3 - 1e-8);
    }
}

TEST(Maze, FreeSpaceIsATreeOfCells) {
    // Without loops the walls leave one piece of free space less a wall for each missing link: the
    // free area is that of the cells and of the links of a spanning tree.
    MazeOptions options;
    options.way.absolute = 0.1;
    options.cells = 7;
    Rng rng(4);
    const Problem problem = maze(options, rng);
    const double pitch = 0.9 / 6;
    const auto blocked = [&](double x, double y) {
        return std::any_of(problem.obstacles.begin(), problem.obstacles.end(), [&](const Box& box) {
            return x > box.low.x && x < box.high.x && y > box.low.y && y < box.high.y;
        });
    };
    std::size_t links = 0;
    for (int i = 0; i < 7; ++i) {
        for (int k = 0; k < 7; ++k) {
            const double x = pitch * i + 0.05, y = pitch * k + 0.05;
            EXPECT_FALSE(blocked(x, y));
            if (i < 6) links += !blocked(x + pitch / 2, y);
            if (k < 6) links += !blocked(x, y + pitch / 2);
        }
    }
    EXPECT_EQ(links, 48u);
}

TEST(Spiral, HasTheLegsAskedForAndEndsWhereItSays) {
    SpiralOptions options;
    options.chain.asv_count = 4;
    options.legs = 6;
    for (const auto direction : {SpiralDirection::inward, SpiralDirection::outward}) {
        options.direction = direction;
        Rng rng(6);
        const Problem problem = spiral(options, rng);
        const auto& outer = direction == SpiralDirection::inward ? problem.start : problem.goal;
        for (const Point& point : outer) EXPECT_LT(point.y, 0.1);
    }
}

TEST(Clutter, HasAsManyBoxesAsAskedForAndTheirArea) {
    for (const std::size_t count : {0u, 1u, 5u, 100u, 100'000u}) {
        ClutterOptions options;
        options.obstacles = count;
        options.density = 0.1;
        Rng rng(7);
        const Problem problem = clutter(options, rng);
        ASSERT_EQ(problem.obstacles.size(), count);
        if (count < 100) continue;
        double area = 0;
        for (const Box& box : problem.obstacles)
            area += (box.high.x - box.low.x) * (box.high.y - box.low.y);
        EXPECT_NEAR(area, 0.1, 0.03);
    }
}

// Every parameter that is out of its range is named.

template <class Options>
void expect_named(Problem (*draw)(const Options&, Rng&), const std::string& name,
                  const std::function<void(Options&)>& change) {
    Options options;
    options.chain.asv_count = 5;
    change(options);
    Rng rng(1);
    try {
        draw(options, rng);
        ADD_FAILURE() << name << " was accepted";
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << error.what();
    }
}

TEST(Options, OutOfRangeAreNamed) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    expect_named<CorridorOptions>(corridor, "asvs", [](auto& o) { o.chain.asv_count = 2; });
    expect_named<CorridorOptions>(corridor, "asvs", [](auto& o) { o.chain.asv_count = 201; });
    expect_named<CorridorOptions>(corridor, "clearance", [](auto& o) { o.chain.clearance = -1; });
    expect_named<CorridorOptions>(corridor, "area-margin",
                                  [](auto& o) { o.chain.area_margin = 1; });
    expect_named<CorridorOptions>(corridor, "least-turn", [](auto& o) { o.chain.min_turn = 1; });
    expect_named<CorridorOptions>(corridor, "least-closing",
                                  [](auto& o) { o.chain.min_closing_side = 1; });
    expect_named<CorridorOptions>(corridor, "height-factor",
                                  [&](auto& o) { o.height.factor = nan; });
    expect_named<CorridorOptions>(corridor, "height", [](auto& o) { o.height.absolute = 0; });
    expect_named<CorridorOptions>(corridor, "length", [](auto& o) { o.length = 0.9; });
    expect_named<CorridorOptions>(corridor, "level", [](auto& o) { o.level = 0; });
    expect_named<BendOptions>(bend, "bends", [](auto& o) { o.bends = 0; });
    expect_named<BendOptions>(bend, "leg", [](auto& o) { o.leg = 0.5; });
    expect_named<BendOptions>(bend, "room", [](auto& o) { o.room = 0; });
    expect_named<GauntletOptions>(gauntlet, "walls", [](auto& o) { o.walls = 0; });
    expect_named<GauntletOptions>(gauntlet, "walls", [](auto& o) {
        o.walls = 6;
        o.thickness = 0.3;
    });
    expect_named<GauntletOptions>(gauntlet, "least-offset", [](auto& o) { o.min_offset = 1; });
    expect_named<RoomsOptions>(rooms, "rooms", [](auto& o) { o.rooms = 1; });
    expect_named<RoomsOptions>(rooms, "doors", [](auto& o) { o.doors = 9; });
    expect_named<RoomsOptions>(rooms, "thickness", [](auto& o) { o.thickness = 0; });
    expect_named<MazeOptions>(maze, "way-factor", [](auto& o) { o.way.factor = 0; });
    expect_named<MazeOptions>(maze, "way", [](auto& o) { o.way.absolute = 2; });
    expect_named<MazeOptions>(maze, "cells", [](auto& o) { o.cells = 1; });
    expect_named<MazeOptions>(maze, "cells", [](auto& o) { o.cells = 40; });
    expect_named<MazeOptions>(maze, "wall", [](auto& o) { o.wall = -1; });
    expect_named<SpiralOptions>(spiral, "legs", [](auto& o) { o.legs = 100; });
    expect_named<CrossingOptions>(crossing, "offset", [](auto& o) { o.offset = 1; });
    expect_named<ClutterOptions>(clutter, "obstacles", [](auto& o) { o.obstacles = 2'000'000; });
    expect_named<ClutterOptions>(clutter, "density", [](auto& o) { o.density = 0; });
    expect_named<ClutterOptions>(clutter, "lane", [](auto& o) { o.lane = 9; });
}

TEST(Options, ChainsThatFindNoPlaceEndWithNoRoom) {
    CorridorOptions options;
    options.chain.asv_count = 60;
    Rng rng(1);
    EXPECT_THROW(corridor(options, rng), NoRoom);
}

}  // namespace
}  // namespace asv::core
