#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>
#include <optional>
#include <stop_token>

#include "core/search/search_result.hpp"

namespace asv::core {

using Clock = std::chrono::steady_clock;

/// When a search has to end without a result. Every planner polls it in one place.
struct Limits {
    Clock::time_point deadline = Clock::time_point::max();
    std::size_t max_iterations = std::numeric_limits<std::size_t>::max();
    std::size_t max_nodes = std::numeric_limits<std::size_t>::max();
    std::stop_token stop = {};

    /// Stopped from outside or out of time. Reads the clock: some 30 ns.
    bool expired() const { return stop.stop_requested() || Clock::now() >= deadline; }

    /// The reason to end now, if there is one.
    std::optional<Outcome> reached(const Progress& progress) const {
        if (stop.stop_requested()) return Outcome::stopped;
        if (Clock::now() >= deadline) return Outcome::deadline;
        if (progress.iterations >= max_iterations) return Outcome::iterations;
        if (progress.nodes[0] + progress.nodes[1] >= max_nodes) return Outcome::nodes;
        return std::nullopt;
    }
};

/// The limits with so many times the iterations.
inline Limits with_patience(Limits limits, double patience) {
    constexpr double most = 1e18;
    const double iterations = patience * static_cast<double>(limits.max_iterations);
    limits.max_iterations = static_cast<std::size_t>(std::min(iterations, most));
    return limits;
}

/// The one place in which a search is watched: tells the observer, then says whether a limit is
/// reached, and notes in the result which.
inline bool must_end(const Progress& progress, const Limits& limits, const Observer& observer,
                     SearchResult& result) {
    if (observer) observer(progress);
    const std::optional<Outcome> reason = limits.reached(progress);
    if (reason) result.outcome = *reason;
    return reason.has_value();
}

}  // namespace asv::core
