#include "core/solve/stages/solve_clock.hpp"

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

namespace asv::test {
namespace {

using core::Clock;
using core::SolveClock;

TEST(SolveClock, CountsWhatTheCallerHadSpent) {
    const SolveClock clock(10, 4);
    EXPECT_GE(clock.elapsed(), 4);
    EXPECT_LE(clock.left(), 6);
    EXPECT_LE(clock.moment_before_end(2), Clock::now() + std::chrono::seconds(4));
}

TEST(SolveClock, AnEndlessLimitHasNoEnd) {
    EXPECT_EQ(SolveClock(1e300, 0).moment_before_end(1), Clock::time_point::max());
}

TEST(SolveClock, ItIsSlowWhereTheThreadDoesNotGetToCompute) {
    const SolveClock clock(10, 0);
    EXPECT_GE(clock.slowdown(), 1);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    EXPECT_GT(clock.slowdown(), 2);
}

}  // namespace
}  // namespace asv::test
