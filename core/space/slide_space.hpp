#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/search/search_result.hpp"
#include "core/search/trees/nearest.hpp"
#include "core/space/chain_world.hpp"
#include "core/space/sampling/shape_sampler.hpp"
#include "core/space/steering/slide.hpp"

namespace asv::core {

/// The chain's C-space with steering that slides along what it meets and pulls an end of the chain:
/// centroid, mean heading and turns, in a metric that means motion of the ASVs.
/// Scratch memory inside: one space for each thread.
class SlideSpace {
  public:
    /// Precondition: the world is anchored at the centroid and outlives the space.
    SlideSpace(const ChainWorld& world, const SlideOptions& options);

    std::size_t dimension() const { return world_.chain.dimension(); }
    WrappingAngles wrapping() const { return world_.wrapping(); }
    NearestNeighbours make_index() const { return {world_.metric.scales(), wrapping()}; }
    double distance(std::span<const double> a, std::span<const double> b) const {
        return world_.metric.distance(a, b);
    }
    bool sample(Rng& rng, std::span<double> row) { return sampler_.sample(rng, row); }
    Steered steer(std::span<const double> from, std::span<const double> target,
                  Configurations& visited);

    /// A workspace point that is worth pulling an end of the chain to; passage_share of them by the
    /// bridge test. None when there is no free point to be found.
    std::optional<geometry::Point> pull_target(Rng& rng, double passage_share) const;
    /// Stops on the shortest way that the ASV in the middle would have on its own, from its start
    /// to its goal; empty where finding it would take long.
    std::vector<geometry::Point> guide() const;
    /// Draws a valid configuration whose ASV in the middle is near the point; false when it found
    /// none in some tries.
    bool sample_near(Rng& rng, const geometry::Point& point, std::span<double> row);
    /// Where an ASV is, 0-based, at a configuration.
    geometry::Point position(std::span<const double> row, std::size_t asv);
    std::size_t asv_count() const { return world_.chain.asv_count(); }
    Steered pull(std::span<const double> from, std::size_t asv, const geometry::Point& target,
                 Configurations& visited);

    MotionChecker& checker() { return checker_; }
    std::uint64_t constrained_steps() const { return steering_.steps(); }

  private:
    const ChainWorld& world_;
    MotionChecker checker_;
    SlideSteering steering_;
    ShapeSampler sampler_;
    Pose pose_;
};

}  // namespace asv::core
