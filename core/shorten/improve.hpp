#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "core/search/limits.hpp"
#include "core/search/rng.hpp"
#include "core/search/search_result.hpp"
#include "core/space/steering/slide.hpp"

namespace asv::core {

/// Another path between the same ends, from a new search, and the work that it took; the path is
/// empty where the search failed. See work_of().
struct AnotherPath {
    Configurations path;
    double work = 0;
};

/// What was done, counted.
struct WorkDone {
    std::uint64_t state_checks = 0;       ///< of a MotionChecker
    std::uint64_t constrained_steps = 0;  ///< of a SlideSteering
    std::uint64_t way_point_steps = 0;    ///< of an ElasticBand
};

/// Microseconds of a 2.8 GHz core, roughly, that so much takes for so many ASVs among so many
/// obstacles. Work is counted, not timed, so that the same seed gives the same path on every
/// machine.
double work_of(const WorkDone& done, std::size_t asv_count, std::size_t obstacle_count);

/// Shortens a path until the work is spent: by turns with shortcuts (straight and sliding ones, of
/// all lengths) and by pulling it taut; once that gains nothing more, the same with other paths,
/// which may pass the obstacles on other sides (restart and shortcut: Luna and others, 2013). The
/// limits end it early. Returns the best path; on_better is told the cost of each.
Configurations improve(Configurations path, MotionChecker& checker, const Metric& metric,
                       SlideSteering& steering, const std::function<AnotherPath(Rng&)>& another,
                       double work, const Limits& limits, Rng& rng,
                       const std::function<void(double)>& on_better = {});

}  // namespace asv::core
