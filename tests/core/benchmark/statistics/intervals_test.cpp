#include <algorithm>
#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "core/benchmark/statistics/statistics.hpp"
#include "core/search/rng.hpp"

namespace asv::core::statistics {
namespace {

// The examples of Newcombe (1998, Statistics in Medicine 17), by the method of Clopper and Pearson.
TEST(SuccessInterval, PublishedExamples) {
    struct Example {
        std::size_t successes, trials;
        double low, high;
    };
    for (const auto& [successes, trials, low, high] :
         {Example{81, 263, 0.2527, 0.3676}, Example{15, 148, 0.0578, 0.1617},
          Example{0, 20, 0, 0.1684}, Example{1, 29, 0.0009, 0.1776}}) {
        const Interval interval = success_interval(successes, trials);
        EXPECT_NEAR(interval.low, low, 5e-5) << successes << " of " << trials;
        EXPECT_NEAR(interval.high, high, 5e-5) << successes << " of " << trials;
    }
}

TEST(SuccessInterval, OfAllAndOfNone) {
    // All of n succeed with a chance of p^n, which is 2.5 % at the lower end.
    const Interval all = success_interval(10, 10), none = success_interval(0, 10);
    EXPECT_NEAR(all.low, std::pow(0.025, 0.1), 1e-12);
    EXPECT_EQ(all.high, 1);
    EXPECT_EQ(none.low, 0);
    EXPECT_NEAR(none.high, 1 - std::pow(0.025, 0.1), 1e-12);
    EXPECT_NEAR(success_interval(0, 10, 0.9).high, 1 - std::pow(0.05, 0.1), 1e-12);
}

// The median of a sample drawn from 1, ..., 11 is at most k when 6 of 11 draws are: the chances are
// 0.7 % for k = 2 and 5.1 % for k = 3, 17 % for 4 and 38 % for 5, and the same from above.
TEST(MedianInterval, HasTheEndsOfTheExactBootstrap) {
    const CensoredSample sample{{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}, 0, 0};
    const CensoredInterval interval = median_interval(sample);
    EXPECT_EQ(interval.low, (CensoredValue{3, false}));
    EXPECT_EQ(interval.high, (CensoredValue{9, false}));
    const CensoredInterval narrower = median_interval(sample, {.confidence = 0.5});
    EXPECT_EQ(narrower.low, (CensoredValue{5, false}));
    EXPECT_EQ(narrower.high, (CensoredValue{7, false}));
}

TEST(MedianInterval, IsTheSameEveryTimeAndAnotherOneWithAnotherSeed) {
    Rng rng(5);
    CensoredSample sample{{}, 0, 0};
    for (int i = 0; i < 30; ++i) sample.known.push_back(i + rng.uniform());
    const auto ends = [&](std::uint64_t seed) {
        const CensoredInterval interval = median_interval(sample, {.resamples = 50, .seed = seed});
        return std::pair(interval.low.value, interval.high.value);
    };
    EXPECT_EQ(ends(1), ends(1));
    EXPECT_NE(ends(1), ends(2));
}

TEST(MedianInterval, ReachesBeyondTheLimit) {
    const CensoredInterval some = median_interval({{1, 2, 3, 4, 5, 6}, 5, 10});
    EXPECT_FALSE(some.low.censored);
    EXPECT_EQ(some.high, (CensoredValue{10, true}));
    const CensoredInterval most = median_interval({{1}, 10, 10});
    EXPECT_EQ(most.low, (CensoredValue{10, true}));
    EXPECT_EQ(most.high, (CensoredValue{10, true}));
}

// A bound below a known median says nothing of where the true one lies.
TEST(MedianInterval, AnEndAboveACensoredMedianIsCensored) {
    // Of two runs one is solved: medians are 9, more than 9.5 and more than 10.
    const CensoredInterval interval = median_interval({{9}, 1, 10}, {.confidence = 0.5});
    EXPECT_TRUE(interval.high.censored);
    const CensoredInterval known = median_interval({{9, 9}, 0, 10});
    EXPECT_EQ(known.high, (CensoredValue{9, false}));
}

TEST(MedianInterval, OfOneMeasurementHasNoExtent) {
    const CensoredInterval interval = median_interval({{4}, 0, 10});
    EXPECT_EQ(interval.low, (CensoredValue{4, false}));
    EXPECT_EQ(interval.high, (CensoredValue{4, false}));
}

/// How often the interval holds the true median: near its confidence.
TEST(MedianInterval, CoversTheMedianAboutAsOftenAsItSays) {
    constexpr std::uint64_t seed = 11;
    Rng rng(seed);
    int covered = 0;
    constexpr int trials = 400;
    for (int trial = 0; trial < trials; ++trial) {
        CensoredSample sample{{}, 0, 2};
        for (int i = 0; i < 25; ++i) {
            const double value = -std::log(1 - rng.uniform());  // exponential: the median is ln 2
            if (value < sample.limit)
                sample.known.push_back(value);
            else
                ++sample.censored;
        }
        std::sort(sample.known.begin(), sample.known.end());
        const CensoredInterval interval = median_interval(sample, {.resamples = 500});
        covered += interval.low.value <= std::log(2.0) &&
                           (interval.high.censored || interval.high.value >= std::log(2.0))
                       ? 1
                       : 0;
    }
    EXPECT_GE(covered, 0.90 * trials) << "seed " << seed;
    EXPECT_LE(covered, 0.99 * trials) << "seed " << seed;
}

}  // namespace
}  // namespace asv::core::statistics
