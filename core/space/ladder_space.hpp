#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/search/search_result.hpp"
#include "core/search/trees/nearest.hpp"
#include "core/space/chain_world.hpp"
#include "core/space/ladder_options.hpp"
#include "core/space/straight_space.hpp"

namespace asv::core {

/// The chain's C-space [x, y of ASV 1, heading of broom 1, turns] with the sampling, the distance
/// and the steering of the bidirectional RRT for ASVs: angle enlargement and ladder moves where a
/// straight extension is blocked. Extensions are proven motions instead of tested steps. Scratch
/// memory inside: one space for each thread.
class LadderSpace : public StraightSpace {
  public:
    /// Precondition: the world is anchored at the first ASV and outlives the space.
    LadderSpace(const ChainWorld& world, const LadderOptions& options);

    NearestNeighbours make_index() const { return {scales_, wrapping()}; }
    double distance(std::span<const double> a, std::span<const double> b) const;
    bool sample(Rng& rng, std::span<double> row);
    Steered steer(std::span<const double> from, std::span<const double> target,
                  Configurations& visited);

  private:
    bool draw(Rng& rng, bool any_turn, std::span<double> row);
    bool go(std::span<const double> target, Configurations& visited);
    bool enlarge(std::span<const double> target, Configurations& visited);
    bool climb_ladder(std::span<const double> target, Configurations& visited);
    double farthest_motion(std::span<const double> a, std::span<const double> b);

    LadderOptions options_;
    std::vector<double> scales_;
    std::size_t failures_ = 0, lifted_left_ = 0;
    std::vector<double> row_, next_;
};

}  // namespace asv::core
