#pragma once

#include <algorithm>
#include <chrono>
#include <ctime>

#include "core/search/limits.hpp"

namespace asv::core {

/// The time of one call of solve(): it starts where the call starts, less what its caller had spent
/// before. Belongs to the thread that has made it.
class SolveClock {
  public:
    /// Seconds, both.
    SolveClock(double time_limit, double elapsed_before)
        : time_limit_(time_limit),
          call_(Clock::now()),
          begin_(call_ - seconds(elapsed_before)),
          processor_at_call_(processor_seconds()) {}

    /// Seconds since the start.
    double elapsed() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }
    double time_limit() const { return time_limit_; }
    double left() const { return time_limit_ - elapsed(); }

    /// How many times as long as alone on a processor this thread has taken since the call, at
    /// least 1: what others on the machine have cost it so far, they will cost it in what is still
    /// to do.
    double slowdown() const {
        const double passed = std::chrono::duration<double>(Clock::now() - call_).count();
        const double computed = processor_seconds() - processor_at_call_;
        return computed > 0 ? std::max(1.0, passed / computed) : 1.0;
    }

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

    /// Seconds that this thread has computed, 0 where the system does not tell.
    static double processor_seconds() {
        std::timespec time{};
        if (::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time) != 0) return 0;
        return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
    }

    double time_limit_;
    Clock::time_point call_;
    Clock::time_point begin_;
    double processor_at_call_;
};

}  // namespace asv::core
