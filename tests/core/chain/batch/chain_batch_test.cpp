#include "core/chain/batch/chain_batch.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/benchmark/scalar_chain.hpp"
#include "tests/benchmark/worlds.hpp"
#include "tests/kit/geometry/adversarial.hpp"
#include "tests/kit/geometry/each_target.hpp"
#include "tests/kit/geometry/exact_oracle.hpp"
#include "tests/kit/geometry/scalar_sin_cos.hpp"

namespace asv::geometry {
namespace {

using benchmark_worlds::chain_limits;
using benchmark_worlds::Random;
using core::batch::ChainBatch;
using core::batch::ChainLimits;
using geometry::simd::LaneMask;
using geometry::simd::lanes;
using geometry::simd::Pack;
using Row = std::vector<double>;

/// Positions by the stated formula, one operation after the other.
std::vector<Point> positions(const Row& row, const ChainLimits& limits) {
    std::vector<Point> points{{0, 0}};
    const std::size_t links = row.size() - 2;
    for (std::size_t k = 0; k < links && !limits.anchor_lever.empty(); ++k) {
        const auto [sine, cosine] = geometry::simd::sin_cos(row[2 + k]);
        const double arm = limits.link * limits.anchor_lever[k];
        points[0] = {points[0].x + arm * cosine, points[0].y + arm * sine};
    }
    points[0] = {row[0] + points[0].x, row[1] + points[0].y};
    for (std::size_t k = 0; k < links; ++k) {
        const auto [sine, cosine] = geometry::simd::sin_cos(row[2 + k]);
        points.push_back({points[k].x + limits.link * cosine, points[k].y + limits.link * sine});
    }
    return points;
}

bool valid_by_oracle(const Row& row, const ChainLimits& limits, std::span<const Box> boxes) {
    const std::vector<Point> points = positions(row, limits);
    if (!core::reference::shape_valid(row, points, limits)) return false;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        for (const Box& box : boxes) {
            if (!is_empty(box) && oracle::meets({points[k], points[k + 1]}, box)) return false;
        }
    }
    return true;
}

std::vector<Pack> packed(std::span<const Row> rows) {
    std::vector<Pack> packs(rows[0].size());
    for (std::size_t lane = 0; lane < lanes; ++lane) {
        for (std::size_t k = 0; k < packs.size(); ++k) packs[k][lane] = rows[lane][k];
    }
    return packs;
}

/// Squares, long walls, degenerate and empty boxes, and some that touch a link of the chains in a
/// corner, within an ulp.
std::vector<Box> hard_boxes(std::size_t count, std::span<const Row> chains,
                            const ChainLimits& limits, Adversary& draw) {
    std::vector<Box> boxes;
    while (boxes.size() < count) {
        const std::vector<Point> points = positions(
            chains[static_cast<std::size_t>(draw.pick(static_cast<int>(chains.size())))], limits);
        const auto k = static_cast<std::size_t>(draw.pick(static_cast<int>(points.size()) - 1));
        const double t = draw.pick(3) == 0 ? 0 : draw.uniform(0, 1);
        const Point on_link{points[k].x + t * (points[k + 1].x - points[k].x),
                            points[k].y + t * (points[k + 1].y - points[k].y)};
        const Point far{draw.uniform(0, 1), draw.uniform(0, 1)};
        const Point corner = draw.pick(3) == 0 ? draw.nudged(on_link) : far;
        const double wide = draw.pick(5) == 0 ? 0 : draw.uniform(0, 0.03);
        const double high = draw.pick(5) == 0 ? 0 : draw.uniform(0, 0.03);
        Box box{corner, {corner.x + wide, corner.y + high}};
        if (draw.pick(2) == 0) box = {{corner.x - wide, corner.y - high}, corner};
        if (draw.pick(30) == 0) std::swap(box.low, box.high);
        boxes.push_back(box);
    }
    return boxes;
}

std::vector<Row> random_chains(std::size_t points, std::size_t count, Random& random,
                               const ChainLimits& limits) {
    std::vector<Row> chains;
    std::vector<Point> scratch(points);
    while (chains.size() < count) {
        const Row row = benchmark_worlds::random_chain(points, random);
        core::reference::positions(row, limits.link, scratch);
        // Every eighth may violate anything, the others collide at most.
        if (chains.size() % 8 == 0 || core::reference::shape_valid(row, scratch, limits)) {
            chains.push_back(row);
        }
    }
    return chains;
}

TEST(ChainBatch, ValidAsByTheOracleWithTheSameBitsOnEveryTarget) {
    constexpr std::uint64_t seed = 41;
    Adversary draw(seed);
    Random random(seed);
    std::size_t valid_count = 0, count = 0;
    for (const std::size_t points : {2UL, 3UL, 7UL, 15UL, 40UL}) {
        ChainLimits limits = chain_limits(points);
        // Two points are a closing side that turns back exactly, but for rounding.
        if (points == 2) limits.min_area = limits.min_closing_side = 0;
        if (points == 2) limits.min_first_closing_turn = limits.min_last_closing_turn = -1e-12;
        for (const std::size_t boxes : {0UL, 1UL, 7UL, 30UL, 100UL, 700UL}) {
            const auto chains = random_chains(points, 8 * test_count(25), random, limits);
            const BoxIndex index(hard_boxes(boxes, chains, limits, draw));
            ChainBatch batch(points - 1, limits, index);
            for (std::size_t i = 0; i < chains.size(); i += lanes) {
                const auto eight = std::span(chains).subspan(i, lanes);
                for (const std::int64_t target : simd_targets()) {
                    const ForcedTarget forced(target);
                    const LaneMask mask = batch.valid(packed(eight));
                    for (std::size_t lane = 0; lane < lanes; ++lane) {
                        SCOPED_TRACE(::testing::Message()
                                     << "seed " << seed << ", " << hwy::TargetName(target) << ", n "
                                     << points << ", m " << boxes << ", chain " << i + lane);
                        const bool expected = valid_by_oracle(eight[lane], limits, index.boxes());
                        ASSERT_EQ(mask >> lane & 1, expected);
                        valid_count += expected;
                        ++count;
                        const std::vector<Point> at = positions(eight[lane], limits);
                        for (std::size_t k = 0; k < points; ++k) {
                            ASSERT_EQ(batch.x()[k][lane], at[k].x);
                            ASSERT_EQ(batch.y()[k][lane], at[k].y);
                        }
                    }
                }
            }
        }
    }
    EXPECT_GT(valid_count, count / 10);
    EXPECT_LT(valid_count, count - count / 10);
}

TEST(ChainBatch, AmongManyBoxesAsByLookingAtAllOfThem) {
    constexpr std::uint64_t seed = 42;
    Adversary draw(seed);
    Random random(seed);
    const ChainLimits limits = chain_limits(7);
    const auto chains = random_chains(7, 8 * test_count(25), random, limits);
    std::vector<Box> boxes = benchmark_worlds::dust(40'000, random);
    const std::vector<Box> hard = hard_boxes(20, chains, limits, draw);
    boxes.insert(boxes.end(), hard.begin(), hard.end());
    const BoxIndex index(boxes);
    ChainBatch batch(6, limits, index);
    std::size_t valid_count = 0;
    for (std::size_t i = 0; i < chains.size(); i += lanes) {
        const auto eight = std::span(chains).subspan(i, lanes);
        LaneMask expected = 0;
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const std::vector<Point> at = positions(eight[lane], limits);
            const bool valid = core::reference::shape_valid(eight[lane], at, limits) &&
                               !core::reference::meets_any(at, boxes);
            expected |= static_cast<LaneMask>(valid) << lane;
            valid_count += valid;
        }
        for (const std::int64_t target : simd_targets()) {
            const ForcedTarget forced(target);
            ASSERT_EQ(batch.valid(packed(eight)), expected)
                << "seed " << seed << ", " << hwy::TargetName(target) << ", chain " << i;
        }
    }
    EXPECT_GT(valid_count, chains.size() / 10);
    EXPECT_LT(valid_count, chains.size() - chains.size() / 10);
}

/// One valid chain, and what each limit makes of it when it is drawn a little too tight.
TEST(ChainBatch, EveryLimitCounts) {
    Random random(2);
    const auto row = benchmark_worlds::valid_chains(7, 1, {}, random).at(0);
    const std::vector<Row> eight(lanes, row);
    const ChainLimits loose = chain_limits(7);
    const std::vector<Point> at = positions(row, loose);
    const BoxIndex none({});
    const auto valid = [&](const ChainLimits& limits) {
        return ChainBatch(6, limits, none).valid(packed(eight)) == geometry::simd::all_lanes;
    };
    EXPECT_TRUE(valid(loose));
    const auto expect_limit = [&](auto member, double value, double outwards) {
        ChainLimits limits = loose;
        limits.*member = value + 1e-9 * outwards;
        EXPECT_TRUE(valid(limits));
        limits.*member = value - 1e-9 * outwards;
        EXPECT_FALSE(valid(limits));
    };
    const auto minus = [](const Point& p, const Point& q) { return Point{p.x - q.x, p.y - q.y}; };
    const auto cross = [](const Point& p, const Point& q) { return p.x * q.y - p.y * q.x; };
    const Point closing = minus(at[0], at[6]);
    expect_limit(&ChainLimits::min_closing_side, std::hypot(closing.x, closing.y), -1);
    expect_limit(&ChainLimits::min_last_closing_turn, cross(minus(at[6], at[5]), closing) / 0.05,
                 -1);
    expect_limit(&ChainLimits::min_first_closing_turn, cross(closing, minus(at[1], at[0])) / 0.05,
                 -1);
    expect_limit(&ChainLimits::max_total_turn, row[7] - row[2], 1);
    double area = 0, greatest = 0;
    for (std::size_t k = 0; k < 7; ++k) area += cross(at[k], at[(k + 1) % 7]) / 2;
    for (std::size_t k = 3; k < 8; ++k) greatest = std::max(greatest, row[k] - row[k - 1]);
    expect_limit(&ChainLimits::min_area, area, -1);
    expect_limit(&ChainLimits::max_turn, greatest, 1);
    for (std::size_t k = 0; k < 5; ++k) {
        ChainLimits limits = loose;
        limits.min_turn[k] = row[3 + k] - row[2 + k] - 1e-9;
        EXPECT_TRUE(valid(limits));
        limits.min_turn[k] += 2e-9;
        EXPECT_FALSE(valid(limits));
    }
    const auto [left, right] = std::ranges::minmax(at, {}, &Point::x);
    const auto [bottom, top] = std::ranges::minmax(at, {}, &Point::y);
    ChainLimits limits = loose;
    limits.bounds = {{left.x, bottom.y}, {right.x, top.y}};
    EXPECT_TRUE(valid(limits)) << "the bounds are closed";
    for (double* side : {&limits.bounds.low.x, &limits.bounds.low.y, &limits.bounds.high.x,
                         &limits.bounds.high.y}) {
        const double kept = *side;
        *side += side == &limits.bounds.low.x || side == &limits.bounds.low.y ? 1e-9 : -1e-9;
        EXPECT_FALSE(valid(limits));
        *side = kept;
    }
}

/// A motion from one chain towards another, long or short.
struct Motion {
    Row from, step;
};

Motion random_motion(std::size_t points, Random& random, const ChainLimits& limits) {
    const auto ends = random_chains(points, 3, random, limits);
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
    const std::vector<Row> chains = random_chains(points, 50, random, limits);
    const BoxIndex index(hard_boxes(boxes, chains, limits, draw));
    for (std::size_t k = 0; centred && k + 1 < points; ++k) {
        limits.anchor_lever.push_back(static_cast<double>(k + 1) / static_cast<double>(points) - 1);
    }
    for (const std::int64_t target : simd_targets()) {
        const ForcedTarget forced(target);
        ChainBatch batch(points - 1, limits, index);
        for (std::size_t i = 0; i < test_count(100); ++i) {
            SCOPED_TRACE(::testing::Message()
                         << "seed " << seed << ", " << hwy::TargetName(target) << ", motion " << i);
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
