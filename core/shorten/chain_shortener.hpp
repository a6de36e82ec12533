#pragma once

#include <cstddef>
#include <cstdint>

#include "core/shorten/band/elastic_band.hpp"
#include "core/shorten/improve.hpp"
#include "core/space/motion_cost.hpp"
#include "core/space/steering/slide.hpp"

namespace asv::core {

/// What was done for a chain of ASVs, counted.
struct ChainWork {
    std::uint64_t state_checks = 0;       ///< of a MotionChecker
    std::uint64_t constrained_steps = 0;  ///< of a SlideSteering
    std::uint64_t way_point_steps = 0;    ///< of an ElasticBand
};

/// Microseconds of a 2.8 GHz core, roughly, that so much takes for so many ASVs among so many
/// obstacles.
double microseconds(const ChainWork& done, std::size_t asv_count, std::size_t obstacle_count);

/// Spacings of the way points of a path that is pulled taut.
inline constexpr double coarse_spacing = 0.05, fine_spacing = 0.025;

/// Shortens the paths of a chain by turns with shortcuts (straight and sliding ones, and of single
/// coordinates, of all lengths) and by pulling the path taut as an elastic band; crosses paths by
/// hybridisation.
class ChainShortener : public PathShortener {
  public:
    /// All three outlive the shortener; the steering belongs to the checker.
    ChainShortener(MotionChecker& checker, const Metric& metric, SlideSteering& steering);

    double cost(const Configurations& path) override { return cost_.path(path); }
    double work() const override;
    void shorten(Improvement& improvement, Rng& rng) override;
    void cross(const Configurations& earlier, Improvement& improvement, Rng& rng) override;

    /// The shortcuts alone, until so many in a row gain nothing.
    void shortcut(Improvement& improvement, int patience, Rng& rng);
    /// Pulls the path taut, so many times at most, with its way points that far apart (in the
    /// metric).
    void pull_taut(Improvement& improvement, double spacing, int max_pulls);

  private:
    MotionChecker& checker_;
    const Metric& metric_;
    SlideSteering& steering_;
    ElasticBand band_;
    MotionCost cost_;
};

}  // namespace asv::core
