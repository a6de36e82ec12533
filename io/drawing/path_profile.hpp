#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "core/model/path.hpp"
#include "core/model/problem.hpp"

/// What the states of a path measure: the figures beside a picture and in the player.

namespace asv::io {

/// The least distance of any broom to any obstacle, and which two they are (0-based).
struct Clearance {
    double distance = std::numeric_limits<double>::infinity();
    std::size_t broom = 0;
    std::size_t obstacle = 0;
};

/// The figures of one state; lengths in workspace units, angles in radians.
struct StateMeasures {
    double cost = 0;                     ///< since the first state, see core::step_cost()
    std::optional<Clearance> clearance;  ///< none without obstacles
    double area = 0;                     ///< of the closed polygon of a chain of ASVs, positive
    /// The largest turn without its sign, over all vertices of the closed polygon, the two of the
    /// closing side included; none for fewer than three ASVs.
    std::optional<double> tightest_turn;
    std::size_t tightest_asv = 0;  ///< where it is, 0-based
};

/// One entry for each state. A single ASV counts as a broom of length 0.
/// Exact for the clearance: no obstacle is left out. Time: for each broom all obstacles once for
/// every stretch of about half a broom length that it moves.
std::vector<StateMeasures> measure(const core::Problem& problem, const core::Path& path);

/// The end points of a shortest line between the segment and the box; both are the same point
/// where they meet.
geometry::Segment shortest_link(const geometry::Segment& segment, const geometry::Box& box);

/// Broom i of a state; for a single ASV the point itself.
geometry::Segment broom_of(std::span<const geometry::Point> state, std::size_t broom);

/// The length of a broom, of the first link of an arm, or of what a broom would be for a point: the
/// scale of what is small and what is large for the body.
double link_length(const core::Problem& problem);

/// How many segments a state has for clearance: the brooms, or 1 for a single ASV.
std::size_t broom_count(std::size_t asv_count);

}  // namespace asv::io
