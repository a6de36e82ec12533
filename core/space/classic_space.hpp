#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "asv/core/planning/nearest.hpp"
#include "asv/core/planning/result.hpp"
#include "asv/core/space/broom_world.hpp"
#include "asv/core/space/chain_space.hpp"

namespace asv::core {

/// Settings of the C-space as the bidirectional RRT for ASVs uses it; each part can be switched
/// off.
struct ClassicOptions {
    bool stepwise = true;            ///< sample dimension by dimension from anywhere
    bool corridor = true;            ///< sample with ASV 1 in a gap between obstacles
    bool corridor_reversed = true;   ///< sample with ASV n in a gap between obstacles
    double widest_corridor = 0.2;    ///< gap between obstacles that counts as a corridor, units
    bool limit_angles = true;        ///< sample no turn sharper than the sharpest of start and goal
    std::size_t lift_after = 50;     ///< failed samples in a row that lift the limit
    std::size_t lifted_for = 50;     ///< samples for which it stays lifted
    double heading_weight = 0.5;     ///< units per radian: heavy, so that no half turn is asked for
    bool enlarge = true;             ///< angle enlargement
    std::size_t enlarge_tries = 10;  ///< how often the angles open a little more
    double enlarge_share = 0.05;     ///< by which the turns shrink each time
    bool ladder = true;              ///< ladder moves
    double step = 0.001;             ///< resolution of steering, largest motion of an ASV
};

/// The chain's C-space [x, y of ASV 1, heading of broom 1, turns] with the sampling, the distance
/// and the steering of the bidirectional RRT for ASVs: angle enlargement and ladder moves where a
/// straight extension is blocked. Extensions are proven motions instead of tested steps. Scratch
/// memory inside: one space for each thread.
class ClassicSpace : public ChainSpace {
  public:
    /// Precondition: the world is anchored at the first ASV and outlives the space.
    ClassicSpace(const BroomWorld& world, const ClassicOptions& options);

    NearestNeighbours make_index() const { return {scales_, wrapping()}; }
    double distance(std::span<const double> a, std::span<const double> b) const;
    bool sample(Rng& rng, std::span<double> row);
    Steered steer(std::span<const double> from, std::span<const double> target, Rows& visited);

  private:
    bool draw(Rng& rng, bool any_turn, std::span<double> row);
    bool go(std::span<const double> target, Rows& visited);
    bool enlarge(std::span<const double> target, Rows& visited);
    bool climb_ladder(std::span<const double> target, Rows& visited);
    double farthest_motion(std::span<const double> a, std::span<const double> b);

    ClassicOptions options_;
    std::vector<double> scales_;
    std::size_t failures_ = 0, lifted_left_ = 0;
    std::vector<double> row_, next_;
};

}  // namespace asv::core
