#pragma once

#include <cstddef>
#include <cstdint>
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
class LadderSpace {
  public:
    /// Precondition: the world is anchored at the first ASV and outlives the space.
    LadderSpace(const ChainWorld& world, const LadderOptions& options);

    std::size_t dimension() const { return straight_.dimension(); }
    WrappingAngles wrapping() const { return straight_.wrapping(); }
    NearestNeighbours make_index() const { return {scales_, wrapping()}; }
    double distance(std::span<const double> a, std::span<const double> b) const;
    bool sample(Rng& rng, std::span<double> row);
    Steered steer(std::span<const double> from, std::span<const double> target,
                  Configurations& visited);

    /// All that follows is as in a StraightSpace.
    bool from_unit_cube(std::span<const double> unit, std::span<double> row) {
        return straight_.from_unit_cube(unit, row);
    }
    double extent(std::size_t coordinate) const { return straight_.extent(coordinate); }
    void perturb(Rng& rng, std::span<const double> row, double sigma, std::span<double> out) const {
        straight_.perturb(rng, row, sigma, out);
    }
    bool collides(std::span<const double> row) { return straight_.collides(row); }
    bool valid(std::span<const double> row) { return straight_.valid(row); }
    bool motion_valid(std::span<const double> from, std::span<const double> to) {
        return straight_.motion_valid(from, to);
    }
    /// How far the ASVs move, root mean square: unlike in distance(), turns count.
    double motion_length(std::span<const double> from, std::span<const double> to) const {
        return straight_.distance(from, to);
    }
    double cost(std::span<const double> from, std::span<const double> to) {
        return straight_.cost(from, to);
    }
    double cost_lower_bound(std::span<const double> from, std::span<const double> to) {
        return straight_.cost_lower_bound(from, to);
    }
    bool sample_stepwise(Rng& rng, std::span<double> row) {
        return straight_.sample_stepwise(rng, row);
    }
    bool sample_corridor(Rng& rng, std::span<double> row) {
        return straight_.sample_corridor(rng, row);
    }
    std::uint64_t state_checks() const { return straight_.state_checks(); }
    std::uint64_t motion_checks() const { return straight_.motion_checks(); }

  private:
    bool draw(Rng& rng, bool any_turn, std::span<double> row);
    bool go(std::span<const double> target, Configurations& visited);
    bool enlarge(std::span<const double> target, Configurations& visited);
    bool climb_ladder(std::span<const double> target, Configurations& visited);
    double farthest_motion(std::span<const double> a, std::span<const double> b);

    const ChainWorld& world_;
    StraightSpace straight_;  ///< what this space has in common with it
    LadderOptions options_;
    std::vector<double> scales_;
    std::size_t failures_ = 0, lifted_left_ = 0;
    std::vector<double> row_, next_;
    Pose pose_, other_pose_;
};

}  // namespace asv::core
