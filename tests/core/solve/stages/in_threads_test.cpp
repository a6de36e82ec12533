#include "core/solve/stages/in_threads.hpp"

#include <atomic>
#include <stdexcept>
#include <thread>

#include <gtest/gtest.h>

namespace asv::core {
namespace {

TEST(InThreads, EachGetsItsNumberAndAllHaveEndedAfterwards) {
    std::atomic<unsigned> called = 0;
    in_threads(5, std::stop_source(), [&](std::size_t thread) { called |= 1U << thread; });
    EXPECT_EQ(called, 0b11111U);
}

TEST(InThreads, WhatOneThrowsIsThrownByTheCallAndEndsTheOthers) {
    for (const std::size_t thrower : {0U, 2U}) {
        std::stop_source stop;
        const auto work = [&](std::size_t thread) {
            if (thread == thrower) throw std::runtime_error("no more");
            while (!stop.stop_requested()) std::this_thread::yield();
        };
        EXPECT_THROW(in_threads(3, stop, work), std::runtime_error);
    }
}

TEST(InThreads, NoneIsStartedOnceStopIsRequested) {
    std::stop_source stop;
    stop.request_stop();
    std::atomic<int> calls = 0;
    in_threads(8, stop, [&](std::size_t thread) {
        EXPECT_EQ(thread, 0U);
        ++calls;
    });
    EXPECT_EQ(calls, 1);
}

}  // namespace
}  // namespace asv::core
