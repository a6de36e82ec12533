#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <vector>

#include "core/model/problem.hpp"
#include "core/search/rng.hpp"
#include "core/shapes/chain_shapes.hpp"

/// Random chains that meet every requirement: a shape first, then a place for it.

namespace asv::core {

enum class Orientation { clockwise, counter_clockwise, random };

/// Ways to make a problem that has no path for certain. core::check_feasibility() proves both.
enum class Obstruction {
    none,
    turned,  ///< the goal turns the other way: on the way to it the area would have to be zero
    fenced   ///< four boxes that overlap stand around the goal; the start is outside of them
};

/// What every family asks of its starts and goals; lengths in workspace units.
struct ChainOptions {
    /// 1, or 3 to 200: two never enclose the area that is asked for. The fewest with a shape.
    std::size_t asv_count = 3;
    /// Of the start and, unless it is turned, of the goal. Drawn by default, so that problems
    /// differ.
    Orientation orientation = Orientation::random;
    /// None: problems are there to be solved. Not for one ASV, which turns no way and which no
    /// obstacle stops.
    Obstruction obstruction = Obstruction::none;
    /// Least distance of start and goal to obstacles and bounds, 0 to 0.1. One primitive step, far
    /// above the tolerance of 1e-5.
    double clearance = 0.001;
    /// How far above the minimum area, as a share of it, 0 to 0.2. A round number, far above what
    /// the 12 decimals of a file round away.
    double area_margin = 0.02;
    /// Of every vertex, radians, 0 to 0.01: none is straight. Ten times the tolerance.
    double min_turn = 1e-4;
    /// Length of the closing side, 0 to 0.05. A round number, a fifth of a broom.
    double min_closing_side = 0.01;
};

/// No start or goal was found in the space that the other parameters leave.
class NoRoom : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// Throws std::invalid_argument that names the parameter when one is out of its range.
void check(const ChainOptions& options);

/// The asv_count - 2 turns of a valid counter-clockwise shape, drawn as a total turn that is split
/// by a symmetric Dirichlet draw of random concentration: from a few sharp corners to regular arcs.
/// Accepted on area, closing side and closing turns alone.
std::vector<double> random_turns(const ChainOptions& options, const Requirements& requirements,
                                 Rng& rng);

/// Families cut their passages to the measure of the chain: a lone ASV, which needs no room, gets
/// that of the smallest one.
std::size_t measured_asvs(std::size_t asv_count);

/// Where a drawn chain may stand: all its ASVs inside the region.
struct EndRegions {
    Box start;
    Box goal;
};

/// Draws start and goal of the problem inside their regions and free of the obstacles, of one
/// orientation, or obstructed as the options say. Throws NoRoom after many vain draws.
void draw_ends(Problem& problem, const ChainOptions& options, const EndRegions& regions, Rng& rng);

/// Draws the goal of a problem whose start, of a chain, is given: anywhere in its planning window
/// and free of its obstacles, of the orientation of the start, or obstructed as the options say.
/// Their number of ASVs and orientation do not count, and their lengths are meant for brooms 0.05
/// long: they grow with the brooms. Throws NoRoom, and std::invalid_argument for other bodies, 2
/// ASVs or more than 200, and options that are out of range. Precondition: the start is valid.
void draw_goal(Problem& problem, const ChainOptions& options, Rng& rng);

}  // namespace asv::core
