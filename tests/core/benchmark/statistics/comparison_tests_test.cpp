#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "core/benchmark/statistics/statistics.hpp"
#include "core/search/rng.hpp"

namespace asv::core::statistics {
namespace {

// Heights of plants by Darwin, as Cureton (1967) has them: p by scipy.stats.wilcoxon.
TEST(SignedRankTest, PublishedExampleOfPlants) {
    const std::vector<double> differences{6,  8,   14, 16, 23, 24,  28, 29,
                                          41, -48, 49, 56, 60, -67, 75};
    const SignedRank test = signed_rank_test(differences);
    EXPECT_EQ(test.pairs, 15U);
    EXPECT_EQ(test.differing, 15U);
    EXPECT_DOUBLE_EQ(test.negative_ranks, 24);
    EXPECT_DOUBLE_EQ(test.positive_ranks, 96);
    EXPECT_TRUE(test.exact);
    EXPECT_DOUBLE_EQ(test.p, 0.041259765625);
}

// Depression scale factors of Hollander and Wolfe (1973), the example of R's wilcox.test: V = 40,
// one-sided p = 0.01953.
TEST(SignedRankTest, PublishedExampleOfPatients) {
    const std::vector<double> before{1.83, .50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30};
    const std::vector<double> after{.878, .647, .598, 2.05, 1.06, 1.29, 1.06, 3.14, 1.29};
    std::vector<double> differences;
    for (std::size_t i = 0; i < before.size(); ++i) differences.push_back(before[i] - after[i]);
    const SignedRank test = signed_rank_test(differences);
    EXPECT_DOUBLE_EQ(test.positive_ranks, 40);
    EXPECT_DOUBLE_EQ(test.p, 2 * 0.01953125);
}

TEST(SignedRankTest, TiesShareRanksAndZerosKeepTheirs) {
    // Ranks of 0 0 1 1 3 3 4 4: 1.5, 3.5, 5.5, 7.5 each.
    const SignedRank test = signed_rank_test(std::vector<double>{3, 3, -1, 0, 4, -1, 0, -4});
    EXPECT_EQ(test.pairs, 8U);
    EXPECT_EQ(test.differing, 6U);
    EXPECT_DOUBLE_EQ(test.positive_ranks, 18.5);
    EXPECT_DOUBLE_EQ(test.negative_ranks, 14.5);
}

TEST(SignedRankTest, WithoutADifferenceThereIsNoEvidence) {
    EXPECT_EQ(signed_rank_test({}).p, 1);
    EXPECT_EQ(signed_rank_test(std::vector<double>{0, 0, 0}).p, 1);
    EXPECT_EQ(signed_rank_test(std::vector<double>{1}).p, 1) << "of one pair there is none";
    EXPECT_EQ(signed_rank_test(std::vector<double>{1, 2, 3, 4, 5}).p, 2.0 / 32);
}

TEST(SignedRankTest, WhatIsNotFiniteIsRefused) {
    EXPECT_THROW(signed_rank_test(std::vector<double>{1, std::nan("")}), std::invalid_argument);
    EXPECT_THROW(signed_rank_test(std::vector<double>{std::numeric_limits<double>::infinity()}),
                 std::invalid_argument);
}

/// The share of all ways to give signs to the differences that are as far apart, by trying them.
double p_by_trying(std::vector<double> differences) {
    const SignedRank given = signed_rank_test(differences);
    const double bound = std::min(given.positive_ranks, given.negative_ranks);
    std::size_t as_extreme = 0;
    const std::size_t ways = std::size_t{1} << differences.size();
    for (std::size_t way = 0; way < ways; ++way) {
        for (std::size_t i = 0; i < differences.size(); ++i)
            differences[i] = std::copysign(differences[i], (way >> i) & 1U ? 1 : -1);
        const SignedRank other = signed_rank_test(differences);
        as_extreme += std::min(other.positive_ranks, other.negative_ranks) <= bound ? 1U : 0U;
    }
    return static_cast<double>(as_extreme) / static_cast<double>(ways);
}

TEST(SignedRankTest, IsThatOfAllWaysToGiveSigns) {
    constexpr std::uint64_t seed = 3;
    Rng rng(seed);
    for (int round = 0; round < 40; ++round) {
        std::vector<double> differences(1 + rng.below(8));
        // Small whole numbers: many ties and zeros.
        for (double& difference : differences) difference = static_cast<double>(rng.below(7)) - 3;
        EXPECT_NEAR(signed_rank_test(differences).p, p_by_trying(differences), 1e-12)
            << "seed " << seed << ", round " << round;
    }
}

TEST(SignedRankTest, ManyPairsAreJudgedAlmostAsTheExactTestDoes) {
    constexpr std::uint64_t seed = 4;
    Rng rng(seed);
    for (const double shift : {0.0, 0.1, 0.2}) {
        std::vector<double> differences(200);
        for (double& difference : differences) difference = shift + rng.normal();
        const SignedRank exact = signed_rank_test(differences);
        // One more, so small that it changes the sums by one and their ranks by one each.
        differences.push_back(1e-9);
        const SignedRank normal = signed_rank_test(differences);
        EXPECT_TRUE(exact.exact);
        EXPECT_FALSE(normal.exact);
        EXPECT_NEAR(normal.p, exact.p, 0.02 * exact.p + 0.005) << "seed " << seed;
    }
}

// By scipy.stats.wilcoxon(range(-140, 171), zero_method="pratt", correction=True, mode="approx").
TEST(SignedRankTest, ManyPairsWithTiesAndZeros) {
    std::vector<double> differences;
    for (int i = -140; i <= 170; ++i) differences.push_back(i);
    const SignedRank test = signed_rank_test(differences);
    EXPECT_DOUBLE_EQ(test.negative_ranks, 19810);
    EXPECT_NEAR(test.p, 0.005078216638310131, 1e-12);
}

TEST(Holm, HandValues) {
    // In order 0.005, 0.01, 0.03, 0.04, by 4, 3, 2 and 1; the last is no less than the one before.
    const std::vector<double> corrected = holm(std::vector<double>{0.01, 0.04, 0.03, 0.005});
    const std::vector<double> expected{0.03, 0.06, 0.06, 0.02};
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_DOUBLE_EQ(corrected[i], expected[i]) << i;
    EXPECT_EQ(holm(std::vector<double>{0.7, 0.8}), (std::vector<double>{1, 1}));
    EXPECT_TRUE(holm({}).empty());
}

TEST(ChanceOfLess, CountsWinsAndHalvesOfTies) {
    EXPECT_EQ(chance_of_less(std::vector<double>{1, 2}, std::vector<double>{3, 4}), 1);
    EXPECT_EQ(chance_of_less(std::vector<double>{3, 4}, std::vector<double>{1, 2}), 0);
    EXPECT_EQ(chance_of_less(std::vector<double>{5, 5}, std::vector<double>{5}), 0.5);
    // 1 is less than both, 2 equals one and is less than the other, 3 is less than none: 3.5 of 6.
    EXPECT_DOUBLE_EQ(chance_of_less(std::vector<double>{3, 1, 2}, std::vector<double>{2, 2.5}),
                     3.5 / 6);
}

}  // namespace
}  // namespace asv::core::statistics
