#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/search/search_result.hpp"
#include "core/search/trees/nearest.hpp"
#include "core/space/chain_world.hpp"
#include "core/space/motion_cost.hpp"
#include "core/space/proof/batch_checker.hpp"
#include "core/space/sampling/corridors.hpp"
#include "core/space/sampling/shape_sampler.hpp"
#include "core/space/sampling/stepwise_sampler.hpp"

namespace asv::core {

/// The chain's C-space as samplers, roadmaps and optimal trees see it (SampledSpace): straight
/// motions, proven whole, in a metric that means motion of the ASVs.
///
/// A draw from the bounds is valid a few times in a million: the turns have one sign, the area and
/// the closing turns their limits. So the unit cube is mapped on what respects the shape: a place,
/// a heading, a total turn below 2 pi and how it is split over the joints, evenly over all splits.
/// What lacks area or closes wrongly even so is refused before any obstacle is looked at.
/// Scratch memory inside: one space for each thread.
class StraightSpace {
  public:
    /// widest_corridor: gap between obstacles that counts as a corridor, workspace units.
    /// Precondition: the world outlives the space.
    explicit StraightSpace(const ChainWorld& world, double widest_corridor = 0.2);

    std::size_t dimension() const { return world_.chain.dimension(); }
    WrappingAngles wrapping() const { return world_.wrapping(); }
    NearestNeighbours make_index() const { return {world_.metric.scales(), wrapping()}; }
    double distance(std::span<const double> a, std::span<const double> b) const {
        return world_.metric.distance(a, b);
    }
    /// By shape first, then a place (ShapeSampler).
    bool sample(Rng& rng, std::span<double> row) { return shapes_.sample(rng, row); }
    /// Straight, as far as it is proven valid.
    Steered steer(std::span<const double> from, std::span<const double> target,
                  Configurations& visited);

    bool from_unit_cube(std::span<const double> unit, std::span<double> row);
    double extent(std::size_t coordinate) const;
    /// Turns that would get the other sign are mirrored.
    void perturb(Rng& rng, std::span<const double> row, double sigma, std::span<double> out) const;
    /// Does a broom meet an obstacle or is an ASV out of bounds? The shape does not count.
    bool collides(std::span<const double> row);
    bool valid(std::span<const double> row) { return checker_.valid(row); }
    /// As by the checker, asked for only where the batch kernel leaves it open.
    bool motion_valid(std::span<const double> from, std::span<const double> to);
    /// The distance that all ASVs move.
    double cost(std::span<const double> from, std::span<const double> to) {
        return cost_(from, to);
    }
    /// The sum of the ASVs' straight ways.
    double cost_lower_bound(std::span<const double> from, std::span<const double> to);

    /// Dimension by dimension, from anywhere (StepwiseSampler).
    bool sample_stepwise(Rng& rng, std::span<double> row);
    /// Likewise, one end of the chain in a gap between obstacles (Corridors).
    bool sample_corridor(Rng& rng, std::span<double> row);

    MotionChecker& checker() { return checker_; }
    StepwiseSampler& stepwise() { return stepwise_; }
    /// Looked for when first asked for: among many obstacles that takes longer than many a search.
    const Corridors& corridors();

    /// A look of the batch kernel costs about as much as one check, and counts as that.
    std::uint64_t state_checks() const {
        return checker_.state_checks() + (batch_ ? batch_->looks() : 0);
    }
    std::uint64_t motion_checks() const { return checker_.motion_checks() + settled_at_once_; }

  private:
    const ChainWorld& world_;
    MotionChecker checker_;
    StepwiseSampler stepwise_;  ///< its range of turns is that of start and goal
    Pose pose_, other_pose_;
    double widest_corridor_;
    std::optional<Corridors> corridors_;
    ShapeSampler shapes_;
    MotionCost cost_;
    std::optional<BatchChecker> batch_;  ///< of at least 3 ASVs, when first asked
    std::uint64_t settled_at_once_ = 0;  ///< motions that the checker was not asked about
    std::vector<double> next_;
};

}  // namespace asv::core
