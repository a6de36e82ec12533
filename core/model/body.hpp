#pragma once

#include <numbers>
#include <numeric>
#include <variant>
#include <vector>

/// What moves. All bodies are chains of points that rigid links join (see Chain); they differ in
/// what holds them, in what is asked of their shape, and in what their motion costs.

namespace asv::core {

/// Point vehicles that brooms of one length join, free to float, with all requirements on their
/// shape. Costs the distance that all ASVs move.
struct AsvChain {};

/// How one joint of an arm may turn.
struct JointRange {
    /// Goes round without a stop: angles a full turn apart are the same, and it takes the short
    /// way.
    bool wraps = false;
    double low = 0;                      ///< radians, for a joint that does not wrap
    double high = 2 * std::numbers::pi;  ///< radians, for a joint that does not wrap
    friend bool operator==(const JointRange&, const JointRange&) = default;
};

/// What the angle of a joint is measured from; for the first one both are the +x axis.
enum class AngleReference {
    previous_link,  ///< the angle from the link before to this one
    x_axis          ///< the heading of the link
};

/// Links one behind the other, the first of which turns about a fixed base. Links may cross each
/// other. Costs the Euclidean length of the way in the space of its joint angles, radians.
/// Invariant: as many ranges, start and goal angles as links, at least one; lengths positive; start
/// and goal within the ranges; Problem::start and goal are the points of these angles.
struct PlanarArm {
    std::vector<double> links;  ///< lengths, from the base to the tip
    std::vector<JointRange> joints;
    AngleReference angles = AngleReference::previous_link;
    std::vector<double> start;  ///< joint angles, radians
    std::vector<double> goal;   ///< joint angles, radians
};

/// Of all links, workspace units: as far as the tip can get from the base.
inline double total_length(const PlanarArm& arm) {
    return std::accumulate(arm.links.begin(), arm.links.end(), 0.0);
}

/// A point that must not touch an obstacle. (A lone ASV may: only brooms collide.) Costs the
/// distance that it moves.
struct PointBody {};

using Body = std::variant<AsvChain, PlanarArm, PointBody>;

enum class BodyKind { chain, arm, point };

inline BodyKind kind(const Body& body) {
    return static_cast<BodyKind>(body.index());
}

}  // namespace asv::core
