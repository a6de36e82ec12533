#include "tests/kit/batch/line_check.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdio>
#include <vector>

#include <gtest/gtest.h>

#include "tests/kit/batch/batch_worlds.hpp"
#include "tests/kit/geometry/adversary.hpp"
#include "tests/kit/scaled.hpp"

namespace asv::geometry {
namespace {

using Row = std::vector<double>;

constexpr double resolution = 1e-5;

/// The first of so many evenly spaced moments that is not valid by the exact state check, or 1.
double first_invalid(const Row& from, const Row& step, int moments,
                     core::batch::ChainBatch& batch) {
    std::vector<geometry::simd::Pack> rows(from.size());
    for (int first = 0; first <= moments; first += 8) {
        const auto moment = [&](std::size_t lane) {
            return std::min(1.0, (first + static_cast<double>(lane)) / moments);
        };
        for (std::size_t k = 0; k < rows.size(); ++k) {
            for (std::size_t lane = 0; lane < geometry::simd::lanes; ++lane) {
                rows[k][lane] = from[k] + moment(lane) * step[k];
            }
        }
        const geometry::simd::LaneMask invalid = batch.valid(rows) ^ geometry::simd::all_lanes;
        if (invalid != 0) return moment(static_cast<std::size_t>(std::countr_zero(invalid)));
    }
    return 1;
}

struct LineTally {
    std::size_t valid = 0, invalid = 0, falsely_refuted = 0;
};

void check_lines(std::size_t points, std::size_t box_count, LineTally& tally) {
    const std::uint64_t seed = 100 * points + box_count;
    test::Random random(seed);
    const std::vector<Box> boxes = test::dust(box_count, random);
    const BoxIndex index(boxes);
    const core::batch::ChainLimits limits = test::chain_limits(points);
    core::batch::ChainBatch batch(points - 1, limits, index);
    test::LineCheck check(batch);
    const auto chains = test::valid_chains(points, test::scaled(400), boxes, random);
    for (std::size_t i = 1; i < chains.size(); ++i) {
        SCOPED_TRACE(::testing::Message() << "seed " << seed << ", line " << i);
        const Row& from = chains[i - 1];
        Row step = chains[i];
        const double length = std::pow(10, random.uniform(-2, 0));
        for (std::size_t k = 0; k < step.size(); ++k) step[k] = length * (step[k] - from[k]);

        const bool valid = check.valid(from, step, resolution);
        const double prefix = check.valid_prefix(from, step, resolution);
        const double invalid = first_invalid(from, step, 2000, batch);
        EXPECT_EQ(valid, prefix == 1);
        EXPECT_TRUE(invalid == 1 || prefix < invalid) << "proven up to " << prefix;
        // The sampling may have stepped over a corner.
        const bool refuted = !valid && invalid == 1;
        const bool falsely = refuted && first_invalid(from, step, 1'000'000, batch) == 1;
        tally.falsely_refuted += falsely;
        ++(valid || falsely ? tally.valid : tally.invalid);
        if (::testing::Test::HasFailure()) return;
    }
}

TEST(LineCheck, ProvesWhatIsValidAndNothingElse) {
    LineTally tally;
    for (const std::size_t points : {3UL, 7UL, 15UL}) {
        for (const std::size_t boxes : {0UL, 7UL, 300UL}) {
            check_lines(points, boxes, tally);
            if (HasFailure()) return;
        }
    }
    check_lines(3, 40'000, tally);
    std::printf("%zu lines valid, %zu not; falsely refuted: %zu\n", tally.valid, tally.invalid,
                tally.falsely_refuted);
    EXPECT_GT(tally.valid, (tally.valid + tally.invalid) / 10);
    EXPECT_GT(tally.invalid, (tally.valid + tally.invalid) / 10);
    EXPECT_LE(1000 * tally.falsely_refuted, tally.valid);
}

TEST(LineCheck, StopsWhereTheBoxBegins) {
    const std::vector<Box> boxes{{{0.5, 0}, {0.6, 1}}};
    const BoxIndex index(boxes);
    core::batch::ChainLimits limits = test::chain_limits(3);
    core::batch::ChainBatch batch(2, limits, index);
    test::LineCheck check(batch);
    // A right angle that opens to the left, its foremost point at x + 0.05.
    const Row from{0.1, 0.5, 0, 1.5707963267948966};
    const Row step{0.5, 0, 0, 0};
    const double reached = check.valid_prefix(from, step, 1e-7);
    EXPECT_LT(reached, 0.7);
    EXPECT_GT(reached, 0.7 - 2e-5);
    EXPECT_FALSE(check.valid(from, step, 1e-7));
    EXPECT_TRUE(check.valid(from, Row{0.3, 0, 0, 0}, 1e-7));
    EXPECT_EQ(check.valid_prefix(Row{0.5, 0.5, 0, 1.5}, step, 1e-7), 0) << "begins in the box";
}

// Along a wall the clearance does not limit how far a proof reaches.
TEST(LineCheck, SlidesThroughATightCorridor) {
    const double top = 0.5 + 0.05 * std::sin(0.9) + 1e-4;
    const std::vector<Box> boxes{{{0.2, 0}, {0.8, 0.5 - 1e-4}}, {{0.2, top}, {0.8, 1}}};
    const BoxIndex index(boxes);
    const core::batch::ChainLimits limits = test::chain_limits(3);
    core::batch::ChainBatch batch(2, limits, index);
    EXPECT_TRUE(test::LineCheck(batch).valid(Row{0.05, 0.5, 0, 0.9}, Row{0.8, 0, 0, 0}, 0.1));
}

}  // namespace
}  // namespace asv::geometry
