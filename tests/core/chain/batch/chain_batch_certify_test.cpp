#include <bit>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/chain/batch/chain_batch.hpp"
#include "tests/kit/batch/batch_worlds.hpp"
#include "tests/kit/batch/hard_chains.hpp"
#include "tests/kit/geometry/forced_target.hpp"
#include "tests/kit/scaled.hpp"

/// Which stretches of motions are certified, eight at a time, on every instruction set.

namespace asv::geometry {
namespace {

using core::batch::ChainBatch;
using core::batch::ChainLimits;
using geometry::simd::LaneMask;
using geometry::simd::lanes;
using geometry::simd::Pack;
using test::Adversary;
using test::chain_limits;
using test::ForcedTarget;
using test::Random;
using Row = test::HeadingRow;

/// A motion from one chain towards another, long or short.
struct Motion {
    Row from, step;
};

Motion random_motion(std::size_t points, Random& random, const ChainLimits& limits) {
    const auto ends = test::random_chains(points, 3, random, limits);
    Motion motion{ends[1], ends[2]};
    const double length = std::pow(10, random.uniform(-3, 0));
    for (std::size_t k = 0; k < motion.step.size(); ++k) {
        motion.step[k] = length * (motion.step[k] - motion.from[k]);
    }
    return motion;
}

/// Which lanes hold at the moments middle + at * half_length, by the exact state check.
LaneMask valid_at(ChainBatch& batch, const core::batch::Stretches& stretches, double at) {
    std::vector<Pack> rows(stretches.from.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const double t = stretches.middle[lane] + at * stretches.half_length[lane];
            rows[k][lane] = stretches.from[k] + t * stretches.step[k];
        }
    }
    return batch.valid(rows);
}

struct Tally {
    std::size_t certified = 0, truly_valid = 0;
};

/// Cuts the motion into eight stretches, and asks about 201 states of each.
void expect_sound(ChainBatch& batch, const Motion& motion, Tally& tally) {
    core::batch::Stretches stretches{motion.from, motion.step, {}, {}};
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        stretches.middle[lane] = (2.0 * static_cast<double>(lane) + 1) / 16;
        stretches.half_length[lane] = 1 / 16.0;
    }
    const auto [certified, midpoint_valid] = batch.certify(stretches);
    EXPECT_EQ(certified & ~midpoint_valid, 0U);
    EXPECT_EQ(midpoint_valid, valid_at(batch, stretches, 0));
    LaneMask valid = geometry::simd::all_lanes;
    for (int i = -100; i <= 100 && valid != 0; ++i) valid &= valid_at(batch, stretches, i / 100.0);
    EXPECT_EQ(certified & ~valid, 0U) << "certified, but some state is not valid";
    tally.certified += static_cast<std::size_t>(std::popcount(certified));
    tally.truly_valid += static_cast<std::size_t>(std::popcount(valid));
}

void expect_sound(std::size_t points, std::size_t boxes, bool centred, Tally& tally) {
    const std::uint64_t seed = 1000 * points + boxes;
    Random random(seed);
    Adversary draw(seed);
    ChainLimits limits = chain_limits(points);
    const std::vector<Row> chains = test::random_chains(points, 50, random, limits);
    const BoxIndex index(test::hard_boxes(boxes, chains, limits, draw));
    for (std::size_t k = 0; centred && k + 1 < points; ++k) {
        limits.anchor_lever.push_back(static_cast<double>(k + 1) / static_cast<double>(points) - 1);
    }
    for (const std::string& target : geometry::simd::instruction_sets()) {
        const ForcedTarget forced(target);
        ChainBatch batch(points - 1, limits, index);
        for (std::size_t i = 0; i < test::scaled(100); ++i) {
            SCOPED_TRACE(::testing::Message()
                         << "seed " << seed << ", " << target << ", motion " << i);
            expect_sound(batch, random_motion(points, random, limits), tally);
            if (::testing::Test::HasFailure()) return;
        }
    }
}

TEST(ChainBatch, CertifiesNoStretchWithAnInvalidState) {
    Tally tally;
    for (const bool centred : {false, true}) {
        for (const std::size_t points : {3UL, 7UL, 15UL}) {
            for (const std::size_t boxes : {0UL, 3UL, 20UL, 200UL}) {
                expect_sound(points, boxes, centred, tally);
                if (HasFailure()) return;
            }
        }
    }
    RecordProperty("certified", static_cast<int>(tally.certified));
    RecordProperty("valid", static_cast<int>(tally.truly_valid));
    EXPECT_GT(tally.certified, tally.truly_valid / 2) << "of " << tally.truly_valid;
}

}  // namespace
}  // namespace asv::geometry
