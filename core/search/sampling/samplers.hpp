#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/search/configuration_space.hpp"
#include "core/search/sampling/sampler_options.hpp"
#include "core/search/trees/interpolate.hpp"

/// Proposal distributions. A sampler is anything that is called with (space, rng, out) and returns
/// whether out is a valid configuration now; one call tries once, so that a planner counts tries.
/// "Collides" is collision alone (SampledSpace::collides); what is returned is valid in all
/// respects. A body with shape requirements of its own is drawn so that it meets them.

namespace asv::core {

/// A sampler that is chosen at run time.
template <class Space>
using Sampler = std::function<bool(Space&, Rng&, std::span<double>)>;

/// A uniform configuration within the bounds, obstacles or not; false where the body cannot take
/// it.
template <SampledSpace Space>
bool draw_uniform(Space& space, Rng& rng, std::span<double> out) {
    std::vector<double> unit(out.size());
    for (double& u : unit) u = rng.uniform();
    return space.from_unit_cube(unit, out);
}

/// Uniform random: valid ones of uniform draws.
struct UniformSampler {
    template <SampledSpace Space>
    bool operator()(Space& space, Rng& rng, std::span<double> out) const {
        return draw_uniform(space, rng, out) && space.valid(out);
    }
};

/// What the space itself proposes.
struct OwnSampler {
    template <ConfigurationSpace Space>
    bool operator()(Space& space, Rng& rng, std::span<double> out) const {
        return space.sample(rng, out);
    }
};

/// How often a regular grid of at most `count` cells divides each side: the longest cells are
/// halved, thirded, ... as long as the count allows. At least 1 each.
std::vector<std::size_t> grid_divisions(std::span<const double> extents, std::size_t count);

/// A point of cell k of a grid in the unit cube: near its centre, a little aside along each
/// coordinate, the same for all cells. Centres are symmetric to each other, so that links fold
/// exactly back on the base's height and move exactly along a wall: motions that graze it all the
/// way take forever to settle. Precondition: k < product of the divisions.
void grid_point(std::span<const std::size_t> divisions, std::size_t k, std::span<double> unit);

/// The points of a regular grid one after the other, the same ones each time; when they are used
/// up, those of a grid of twice as many. Blind to gaps finer than its cells.
class GridSampler {
  public:
    /// Precondition: count > 0, the number of cells of the first grid.
    explicit GridSampler(std::size_t count) : count_(count) {}

    template <SampledSpace Space>
    bool operator()(Space& space, Rng&, std::span<double> out) {
        if (next_ == cells_) {
            std::vector<double> extents(out.size());
            for (std::size_t i = 0; i < extents.size(); ++i) extents[i] = space.extent(i);
            divisions_ = grid_divisions(extents, count_);
            cells_ = 1;
            for (const std::size_t side : divisions_) cells_ *= side;
            next_ = 0;
            count_ *= 2;
            unit_.resize(out.size());
        }
        grid_point(divisions_, next_++, unit_);
        return space.from_unit_cube(unit_, out) && space.valid(out);
    }

  private:
    std::size_t count_, next_ = 0, cells_ = 0;
    std::vector<std::size_t> divisions_;
    std::vector<double> unit_;
};

/// Gaussian sampling (Boor, Overmars and van der Stappen, 1999): of a uniform configuration that
/// collides and a normal displacement of it, the second is kept if it is valid: places near
/// obstacles.
struct GaussianSampler {
    double sigma;  ///< of each coordinate, in the metric

    template <SampledSpace Space>
    bool operator()(Space& space, Rng& rng, std::span<double> out) const {
        std::vector<double> blocked(out.size());
        if (!draw_uniform(space, rng, blocked) || !space.collides(blocked)) return false;
        space.perturb(rng, blocked, sigma, out);
        return space.valid(out);
    }
};

/// The bridge test (Hsu, Jiang, Reif and Sun, 2003): the middle between a uniform configuration and
/// a normal displacement of it that both collide, if it is valid: narrow places.
struct BridgeSampler {
    double sigma;  ///< of each coordinate, in the metric

    template <SampledSpace Space>
    bool operator()(Space& space, Rng& rng, std::span<double> out) const {
        std::vector<double> end(out.size()), other(out.size());
        if (!draw_uniform(space, rng, end) || !space.collides(end)) return false;
        space.perturb(rng, end, sigma, other);
        if (!space.collides(other)) return false;
        interpolate(end, other, 0.5, out);
        return space.valid(out);
    }
};

/// Do some, but not all, of the normal displacements of the row collide? Then it is near the mouth
/// or the wall of a passage. No displacement, no question: true.
template <SampledSpace Space>
bool at_passage(Space& space, Rng& rng, std::span<const double> row, std::size_t displacements,
                double sigma) {
    if (displacements == 0) return true;
    std::vector<double> other(row.size());
    std::size_t colliding = 0;
    for (std::size_t i = 0; i < displacements; ++i) {
        space.perturb(rng, row, sigma, other);
        if (space.collides(other)) ++colliding;
    }
    return colliding > 0 && colliding < displacements;
}

/// Uniform configurations at a passage.
struct PassageSampler {
    double sigma;               ///< of each coordinate, in the metric
    std::size_t displacements;  ///< that are looked at

    template <SampledSpace Space>
    bool operator()(Space& space, Rng& rng, std::span<double> out) const {
        return UniformSampler{}(space, rng, out) &&
               at_passage(space, rng, out, displacements, sigma);
    }
};

/// One of several samplers for each draw, with probabilities in proportion to their weights.
template <class Space>
class MixedSampler {
  public:
    /// Precondition: some weight is positive, none is negative.
    explicit MixedSampler(std::vector<std::pair<double, Sampler<Space>>> parts)
        : parts_(std::move(parts)) {
        for (const auto& part : parts_) total_ += part.first;
    }

    bool operator()(Space& space, Rng& rng, std::span<double> out) {
        double left = rng.uniform(0, total_);
        std::size_t chosen = 0;
        while (chosen + 1 < parts_.size() && (left -= parts_[chosen].first) >= 0) ++chosen;
        return parts_[chosen].second(space, rng, out);
    }

  private:
    std::vector<std::pair<double, Sampler<Space>>> parts_;
    double total_ = 0;
};

/// A space that proposes dimension by dimension, and with an end of the chain in a corridor.
template <class Space>
concept ChainSampling = requires(Space& space, Rng& rng, std::span<double> out) {
    { space.sample_stepwise(rng, out) } -> std::same_as<bool>;
    { space.sample_corridor(rng, out) } -> std::same_as<bool>;
};

/// The sampler of the options. Throws std::invalid_argument where the space does not have it, or
/// nothing is in the mix.
template <SampledSpace Space>
Sampler<Space> make_sampler(const SamplerOptions& options) {
    const auto one = [&](SamplerKind kind) -> Sampler<Space> {
        switch (kind) {
            case SamplerKind::uniform:
                return UniformSampler{};
            case SamplerKind::grid:
                return GridSampler(options.grid_cells);
            case SamplerKind::gaussian:
                return GaussianSampler{options.sigma};
            case SamplerKind::bridge:
                return BridgeSampler{options.sigma};
            case SamplerKind::passage:
                return PassageSampler{options.sigma, options.displacements};
            case SamplerKind::stepwise:
            case SamplerKind::corridor:
                if constexpr (ChainSampling<Space>) {
                    if (kind == SamplerKind::stepwise)
                        return [](Space& s, Rng& rng, auto out) {
                            return s.sample_stepwise(rng, out);
                        };
                    return [](Space& s, Rng& rng, auto out) { return s.sample_corridor(rng, out); };
                }
                throw std::invalid_argument("only a chain is sampled stepwise or in corridors");
            default:
                return OwnSampler{};
        }
    };
    if (options.kind != SamplerKind::mix) return one(options.kind);
    std::vector<std::pair<double, Sampler<Space>>> parts;
    for (std::size_t i = 0; i < options.weights.size(); ++i)
        if (options.weights[i] > 0)
            parts.emplace_back(options.weights[i], one(static_cast<SamplerKind>(i)));
    if (parts.empty()) throw std::invalid_argument("a mix of samplers needs a weight above 0");
    return MixedSampler<Space>(std::move(parts));
}

/// A space that proposes what a sampler draws, and is the given one in all other operations.
template <SampledSpace Space>
class SampledBy : public Space {
  public:
    /// arguments: those of the space.
    template <class... Arguments>
    explicit SampledBy(Sampler<Space> sampler, Arguments&&... arguments)
        : Space(std::forward<Arguments>(arguments)...), sampler_(std::move(sampler)) {}

    bool sample(Rng& rng, std::span<double> out) { return sampler_(*this, rng, out); }

  private:
    Sampler<Space> sampler_;
};

}  // namespace asv::core
