#pragma once

#include <span>
#include <vector>

#include "core/chain/chain.hpp"
#include "core/shorten/band/block_tridiagonal.hpp"

namespace asv::core {

/// The cost of a path, the sum of the distances that the ASVs travel from way point to way point,
/// as springs: each ASV is tied to its next place, as stiff as the distance is short, so that the
/// springs pull like strings do, with a force of 1 (iteratively reweighted least squares). Unknowns
/// are the heading coordinates [x, y of the anchor, heading of each broom] of all way points but
/// the first and the last. Holds scratch memory.
class WayTies {
  public:
    explicit WayTies(const Chain& chain);

    /// Fills the system with the stiffness and force with the pull. Distances count as at least
    /// `softening`; each ASV is held where it is by a spring of stiffness `damping`.
    /// Precondition: poses.size() >= 3, force.size() == (poses.size() - 2) * dimension.
    void tie(std::span<const Pose> poses, double softening, double damping,
             BlockTridiagonal& system, std::span<double> force);

  private:
    void add_stiffness(const Pose& a, const Pose& b, double sign, std::span<double> block);
    void add_force(const Pose& pose, double sign, std::span<double> force) const;

    const Chain& chain_;
    std::vector<double> stiffness_;        ///< of the tie of each ASV
    std::vector<double> behind_;           ///< sum of it over the ASVs behind each broom
    std::vector<double> pull_x_, pull_y_;  ///< on each ASV, toward its next place
};

}  // namespace asv::core
