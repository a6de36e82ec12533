#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "core/benchmark/statistics/statistics.hpp"

namespace asv::core::statistics {
namespace {

TEST(Quantile, LiesBetweenNeighbours) {
    const std::array<double, 4> values{1, 2, 4, 8};
    EXPECT_DOUBLE_EQ(quantile(values, 0), 1);
    EXPECT_DOUBLE_EQ(quantile(values, 0.25), 1.75);
    EXPECT_DOUBLE_EQ(quantile(values, 0.5), 3);
    EXPECT_DOUBLE_EQ(quantile(values, 1), 8);
    EXPECT_DOUBLE_EQ(quantile(std::array<double, 1>{5}, 0.5), 5);
}

TEST(SpreadOf, HandValues) {
    const Spread spread = spread_of({9, 2, 4, 4, 5, 4, 5, 7});
    EXPECT_EQ(spread.count, 8U);
    EXPECT_DOUBLE_EQ(spread.least, 2);
    EXPECT_DOUBLE_EQ(spread.median, 4.5);
    EXPECT_DOUBLE_EQ(spread.greatest, 9);
    EXPECT_DOUBLE_EQ(spread.mean, 5);
    // Squares of the differences: 9 + 1 + 1 + 1 + 0 + 0 + 4 + 16 = 32.
    EXPECT_DOUBLE_EQ(spread.deviation, std::sqrt(32.0 / 7));
}

TEST(SpreadOf, OfOneAndOfNone) {
    EXPECT_DOUBLE_EQ(spread_of({3}).median, 3);
    EXPECT_DOUBLE_EQ(spread_of({3}).deviation, 0);
    EXPECT_EQ(spread_of({}).count, 0U);
    EXPECT_DOUBLE_EQ(spread_of({}).median, 0);
}

TEST(CensoredQuantile, OfMostlyCensoredIsBeyondTheLimit) {
    const CensoredSample sample{{1, 2}, 3, 10};
    EXPECT_EQ(quantile(sample, 0), (CensoredValue{1, false}));
    EXPECT_EQ(quantile(sample, 0.25), (CensoredValue{2, false}));
    EXPECT_EQ(quantile(sample, 0.5), (CensoredValue{10, true}));
    EXPECT_EQ(quantile(sample, 1), (CensoredValue{10, true}));
}

TEST(CensoredQuantile, BetweenAKnownAndACensoredOneIsABound) {
    // The third is more than 10, so the median is more than (2 + 10) / 2.
    EXPECT_EQ(quantile(CensoredSample{{1, 2}, 2, 10}, 0.5), (CensoredValue{6, true}));
}

TEST(CensoredQuantile, WithoutCensoredOnesIsThatOfTheValues) {
    const CensoredSample sample{{1, 2, 4, 8}, 0, 10};
    for (const double share : {0.0, 0.1, 0.5, 0.9, 1.0})
        EXPECT_EQ(quantile(sample, share), (CensoredValue{quantile(sample.known, share), false}));
}

TEST(PenalisedMean, CountsWhatIsCensoredTwice) {
    EXPECT_DOUBLE_EQ(penalised_mean({{1, 3}, 2, 10}), 11);
    EXPECT_DOUBLE_EQ(penalised_mean({{}, 4, 10}, 1), 10);
    EXPECT_DOUBLE_EQ(penalised_mean({{1, 3}, 0, 10}), 2);
}

}  // namespace
}  // namespace asv::core::statistics
