#pragma once

#include <cstddef>
#include <vector>

#include "asv/core/planning/limits.hpp"
#include "asv/core/planning/rng.hpp"
#include "asv/core/planning/tree.hpp"
#include "asv/core/space/motion.hpp"
#include "asv/core/space/steering/slide.hpp"

namespace asv::core {

/// Settings of the search over slides and pulls.
struct SlidePullOptions {
    SlideOptions steering;
    bool slide = true;
    bool pull = true;
    double pull_share = 0.5;
    double passage_share = 0.5;
    std::size_t pull_candidates = 24;
};

struct SlidePullResult {
    bool solved = false;
    Rows path;  ///< rows from start to goal, joined by certified straight motions
    std::size_t nodes[2] = {0, 0};
    std::size_t iterations = 0;
};

SlidePullResult slide_pull(MotionChecker& checker, const Metric& metric,
                           std::span<const double> start, std::span<const double> goal,
                           const SlidePullOptions& options, const Limits& limits, Rng& rng);

}  // namespace asv::core
