#pragma once

#include <cstddef>
#include <optional>

#include "core/generate/random_chain.hpp"
#include "core/model/problem.hpp"
#include "core/search/rng.hpp"

/// Families of random problems in the unit square. Every function draws from the given stream only,
/// so the same options and the same seed give the same problem. Start and goal meet every
/// requirement; whether there is a path is another question (see vouch.hpp). Each field says its
/// range, its unit (wu: workspace units, in which a broom is 0.05 long and the square 1 wide) and
/// why its default is what it is. A parameter that is out of range throws std::invalid_argument
/// that names it; a start or goal that finds no place throws NoRoom.

namespace asv::core {

/// Height of a corridor or door.
struct PassageHeight {
    /// Times min_flat_height, 0.05 to 50. 1.3, as in the corridors of the field: a flat chain of 7
    /// ASVs passes one that is 0.03 wu high.
    double factor = 1.3;
    /// Taken instead where given, 0.001 to 0.5 wu. None: the factor suits every number of ASVs.
    std::optional<double> absolute;

    /// Throws std::invalid_argument when out of range.
    double value(std::size_t asv_count, const Requirements& requirements) const;
};

/// Width of a way that a chain can turn in.
struct WayWidth {
    /// Times round_diameter, 0.1 to 20. 1.1, a round number: a round chain fits with a little room.
    double factor = 1.1;
    /// Taken instead where given, 0.005 to 0.9 wu. None: the factor suits every number of ASVs.
    std::optional<double> absolute;

    /// Throws std::invalid_argument when out of range.
    double value(std::size_t asv_count, const Requirements& requirements) const;
};

/// One straight corridor between two blocks that reach the upper and the lower border.
struct CorridorOptions {
    ChainOptions chain;
    PassageHeight height;
    /// 0.01 to 0.8 wu. By default 1.05 times the length of the chain where that leaves two rooms
    /// (up to 0.5); else at most 1/3 and so short that the round chain fits into both rooms: then
    /// the chain hangs out of both mouths.
    std::optional<double> length;
    /// y of the corridor's axis, 0.1 to 0.9 wu. Drawn by default, so that problems differ.
    std::optional<double> level;
};
Problem corridor(const CorridorOptions& options, Rng& rng);

/// One corridor with right-angled bends through a solid block, from a room on the left to a room on
/// the right (even number of bends) or at the top (odd).
struct BendOptions {
    ChainOptions chain;
    /// One bend can be passed at little more than the least height, by three ASVs at 1.3 times that
    /// or so. Bends to either side one after the other cannot, since a chain turns one way only:
    /// below about 2.5 no path is known.
    PassageHeight height{3.0, std::nullopt};
    /// How many, 1 to 8. Two: the fewest that lead to a room on the right.
    std::size_t bends = 2;
    double leg = 0.15;   ///< least length of an upright leg, 0.02 to 0.35 wu; a round number
    double room = 0.28;  ///< width of the two rooms, 0.1 to 0.4 wu; a round number
};
Problem bend(const BendOptions& options, Rng& rng);

/// Several walls in a row, each with one corridor at a height of its own.
struct GauntletOptions {
    ChainOptions chain;
    PassageHeight height;
    std::size_t walls = 2;   ///< 1 to 6; the fewest that are in a row
    double thickness = 0.1;  ///< of each wall, 0.005 to 0.5 wu; a round number, two brooms
    /// Between the axes of neighbouring corridors, 0 to 0.35 wu. A round number.
    double min_offset = 0.2;
    /// Width of the first and last room, 0.02 to 0.48 wu. By default 1.25 times round_diameter, at
    /// least 0.2, at most 0.34 and what leaves 0.1 between the walls.
    std::optional<double> room;
};
Problem gauntlet(const GauntletOptions& options, Rng& rng);

/// Rooms in a row with doors between them and shelves in them.
struct RoomsOptions {
    ChainOptions chain;
    PassageHeight height;     ///< of the doors
    std::size_t rooms = 3;    ///< 2 to 6; three as in the problems of the field
    std::size_t doors = 2;    ///< in each wall, 1 to 4; two, so that there is a choice
    double thickness = 0.08;  ///< of each wall, 0.005 to 0.3 wu; a round number
    /// Boxes with sides of 0.04 to 0.12 wu anywhere in the rooms, 0 to 50. A round number.
    std::size_t shelves = 2;
    double shelf_gap = 0.08;  ///< least distance of a shelf to a door, 0 to 0.3 wu; a round number
};
Problem rooms(const RoomsOptions& options, Rng& rng);

/// A perfect maze (one way between any two cells) of square cells, drawn by depth-first search.
/// The start is in a corner, the goal in the cell that is farthest from it.
struct MazeOptions {
    ChainOptions chain;
    WayWidth way;
    double wall = 0.02;  ///< least thickness of a wall, 0.001 to 0.3 wu; thin: more cells fit
    /// On each side, 2 to 60. By default as many as fit: the way decides.
    std::optional<std::size_t> cells;
};
Problem maze(const MazeOptions& options, Rng& rng);

enum class SpiralDirection { inward, outward, random };

/// A square spiral.
struct SpiralOptions {
    ChainOptions chain;
    WayWidth way;
    double wall = 0.05;  ///< between two turns of the spiral, 0.001 to 0.3 wu; one broom
    /// Straight parts, 2 to 200. By default as many as fit: the way decides.
    std::optional<std::size_t> legs;
    /// Of the way from start to goal. Drawn by default, so that problems differ.
    SpiralDirection direction = SpiralDirection::random;
};
Problem spiral(const SpiralOptions& options, Rng& rng);

enum class Branch { east, north, west, south, random };

/// A crossing of two wide roads; start and goal each in an arm and in the crossing itself.
struct CrossingOptions {
    ChainOptions chain;
    WayWidth road;  ///< width of both roads, at least 0.25 wu where the factor decides
    /// The axes are drawn this far around the middle, 0 to 0.2 wu. A round number, one broom.
    double offset = 0.05;
    Branch start_arm = Branch::random;  ///< drawn by default, so that problems differ
    Branch goal_arm = Branch::random;   ///< drawn by default, from the other arms
};
Problem crossing(const CrossingOptions& options, Rng& rng);

/// Random boxes, which may overlap.
struct ClutterOptions {
    ChainOptions chain;
    std::size_t obstacles = 20;  ///< 0 to 1,000,000; a round number
    /// Sum of all areas, 0.0001 to 0.9 of the square; decides the sides. 0.15 is a round number.
    double density = 0.15;
    double side_ratio = 3;  ///< longest to shortest side, 1 to 20; a round number
    /// Width of a winding lane that is kept free from the start to the goal, as a multiple of
    /// round_diameter, 0 to 5. By default 1.3 where the boxes are closer to each other than the
    /// chain is wide, else 0: no lane.
    std::optional<double> lane;
};
Problem clutter(const ClutterOptions& options, Rng& rng);

}  // namespace asv::core
