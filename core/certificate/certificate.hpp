#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/model/problem.hpp"

/// What a proof that there is no path says, as plain numbers that anybody can check: the code that
/// finds the proof writes them, and code that shares nothing with it checks them
/// (core/certificate_check). e is the tolerance, s = max_step + e the farthest that an ASV gets in
/// a primitive step. Obstacles and ASVs count from 0.

namespace asv::core {

/// The chain cannot enclose the area that is required.
struct AreaProof {
    double chain_length = 0;   ///< the greatest: of all brooms together, each e too long
    double greatest_area = 0;  ///< half a circle of that length; 0 for fewer than three ASVs
    double required_area = 0;  ///< less e
};

/// Start and goal turn in opposite directions, and no step is long enough to change that.
struct OrientationProof {
    double start_area = 0;  ///< positive: counter-clockwise
    double goal_area = 0;
    double greatest_change = 0;  ///< of the area, in one step
    double required_area = 0;    ///< less e
};

/// Two walls that face each other: obstacles, or the outside of the bounds where there is none.
struct FacingWalls {
    /// The left and the right one if upright, else the lower and the upper one.
    std::array<std::optional<std::size_t>, 2> walls;
    bool upright = false;
};

/// A seam between two walls that the middle of no chain gets through (core/bounds/seams.hpp).
struct ClosedSeam {
    FacingWalls between;
    Box gap;           ///< the rectangle between the walls, each shrunk by SeparationProof::shrink
    double width = 0;  ///< of the gap between walls that are shrunk by e alone
    double depth = 0;  ///< for how long the shrunk walls run side by side
};

/// These obstacles, shrunk, and these seams keep one ASV from its goal.
struct SeparationProof {
    std::size_t asv = 0;                 ///< one in the middle of the chain where there are seams
    double shrink = 0;                   ///< e + s / 2, see core/bounds/asv_plane.hpp
    std::vector<std::size_t> obstacles;  ///< ascending
    std::vector<ClosedSeam> seams = {};
};

/// A corridor that is too low for the chain (core/bounds/corridors/low_corridors.hpp).
struct ClosedCorridor {
    FacingWalls between;
    /// The middle of the chain is on no cross-section from here to there: x, or y if upright.
    double from = 0, to = 0;
    double height = 0;         ///< from wall to wall, 0 or less where they touch or overlap
    double greatest_area = 0;  ///< of a chain between the walls, a bound that need not be sharp
};

/// These obstacles, shrunk, and these corridors keep the middle of the chain from its goal.
struct CorridorProof {
    double shrink = 0;                   ///< as in SeparationProof
    double required_area = 0;            ///< less e
    std::vector<std::size_t> obstacles;  ///< ascending
    std::vector<ClosedCorridor> corridors;
};

using InfeasibilityProof =
    std::variant<AreaProof, OrientationProof, SeparationProof, CorridorProof>;

/// What a proof is about, so that it is not taken for one about another problem.
struct CertifiedProblem {
    std::size_t asv_count = 0;
    std::size_t obstacle_count = 0;
    double broom_length = 0;
    double max_step = 0;
    double tolerance = 0;
    std::string digest;  ///< of all numbers of the problem
};

/// The facts about a problem, with the digest that its reader has made.
inline CertifiedProblem certified(const Problem& problem, std::string digest) {
    const Requirements& r = problem.requirements;
    return {problem.asv_count(), problem.obstacles.size(), r.broom_length, r.max_step,
            r.tolerance,         std::move(digest)};
}

struct Certificate {
    CertifiedProblem problem;
    InfeasibilityProof proof;
};

}  // namespace asv::core
