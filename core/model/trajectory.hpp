#pragma once

#include <cstddef>
#include <vector>

#include "core/model/path.hpp"

namespace asv::core {

/// When a body is where: the trajectory is its samples, and from each to the next every vehicle
/// moves straight at a constant velocity. So, with p(k) for where a vehicle is at the time t(k) and
/// d(k) = t(k) - t(k - 1),
///
///     its velocity before sample k is      v(k) = (p(k) - p(k - 1)) / d(k),
///     its acceleration at sample k is      (v(k + 1) - v(k)) / ((d(k) + d(k + 1)) / 2),
///
/// the change of its velocity from the middle of one interval to the middle of the next. It is at
/// rest before the first sample and after the last one: v and d are 0 there. A limit holds for the
/// Euclidean length of a velocity or an acceleration.
struct Trajectory {
    Path states;
    std::vector<double> times = {};  ///< seconds, increasing; one for each state

    std::size_t size() const { return times.size(); }
    /// Seconds from the first sample to the last; 0 where there is none.
    double duration() const { return times.empty() ? 0 : times.back() - times.front(); }
};

}  // namespace asv::core
