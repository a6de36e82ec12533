#pragma once

#include <chrono>

#include "core/search/limits.hpp"

namespace asv::core {

/// The time of one call of solve(): it starts where the call starts, less what its caller had spent
/// before.
class SolveClock {
  public:
    /// Seconds, both.
    SolveClock(double time_limit, double elapsed_before)
        : time_limit_(time_limit), begin_(Clock::now() - seconds(elapsed_before)) {}

    /// Seconds since the start.
    double elapsed() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }
    double time_limit() const { return time_limit_; }
    double left() const { return time_limit_ - elapsed(); }

    /// The moment at which so many seconds are left.
    Clock::time_point moment_before_end(double reserve) const {
        const double duration = time_limit_ - reserve;
        return duration < longest ? begin_ + seconds(duration) : Clock::time_point::max();
    }

  private:
    /// Beyond what a clock can count, in seconds.
    static constexpr double longest = 1e9;

    static Clock::duration seconds(double count) {
        return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(count));
    }

    double time_limit_;
    Clock::time_point begin_;
};

}  // namespace asv::core
