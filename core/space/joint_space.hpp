#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/search/configuration_space.hpp"
#include "core/space/joint_world.hpp"

namespace asv::core {

/// The C-space of an arm or a point: the Euclidean metric of its joint angles (radians) or of the
/// plane, which is also what a motion costs; joints that wrap take the short way. Motions are
/// straight lines, and proven (see MotionChecker).
class JointSpace {
  public:
    /// The world has to outlive the space.
    explicit JointSpace(const JointWorld& world);

    std::size_t dimension() const { return world_.dimension(); }
    WrappingAngles wrapping() const { return {0, world_.wrapping_count()}; }
    NearestNeighbours make_index() const;
    double distance(std::span<const double> a, std::span<const double> b) const;
    bool sample(Rng& rng, std::span<double> row);
    /// Straight toward the target as far as that is proven.
    Steered steer(std::span<const double> from, std::span<const double> target,
                  Configurations& visited);

    bool from_unit_cube(std::span<const double> cube, std::span<double> row) const;
    double extent(std::size_t coordinate) const;
    void perturb(Rng& rng, std::span<const double> row, double sigma, std::span<double> out) const;
    bool collides(std::span<const double> row);
    bool valid(std::span<const double> row);
    bool motion_valid(std::span<const double> from, std::span<const double> to);
    /// No path between them costs less.
    double cost_lower_bound(std::span<const double> from, std::span<const double> to) const {
        return distance(from, to);
    }
    double cost(std::span<const double> from, std::span<const double> to) const {
        return distance(from, to);
    }

    /// Where the body is to be seen in the picture of a tree: the tip of an arm, the point.
    geometry::Point position(std::span<const double> row);

    std::uint64_t state_checks() const { return checker_.state_checks(); }
    std::uint64_t motion_checks() const { return checker_.motion_checks(); }

  private:
    const JointWorld& world_;
    MotionChecker checker_;
    std::vector<double> from_, to_, drawn_;
    Pose pose_;
};

}  // namespace asv::core
