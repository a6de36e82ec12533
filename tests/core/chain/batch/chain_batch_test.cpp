#include "core/chain/batch/chain_batch.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/benchmark/scalar_chain.hpp"
#include "tests/kit/batch/batch_worlds.hpp"
#include "tests/kit/batch/hard_chains.hpp"
#include "tests/kit/geometry/exact_oracle.hpp"
#include "tests/kit/geometry/forced_target.hpp"
#include "tests/kit/scaled.hpp"

/// Which chains are valid, eight at a time, on every instruction set.

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

bool valid_by_oracle(const Row& row, const ChainLimits& limits, std::span<const Box> boxes) {
    const std::vector<Point> points = test::kernel_positions(row, limits);
    if (!core::reference::shape_valid(row, points, limits)) return false;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        for (const Box& box : boxes) {
            if (!is_empty(box) && test::exact_meets({points[k], points[k + 1]}, box)) return false;
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
            const auto chains = test::random_chains(points, 8 * test::scaled(25), random, limits);
            const BoxIndex index(test::hard_boxes(boxes, chains, limits, draw));
            ChainBatch batch(points - 1, limits, index);
            for (std::size_t i = 0; i < chains.size(); i += lanes) {
                const auto eight = std::span(chains).subspan(i, lanes);
                for (const std::string& target : geometry::simd::instruction_sets()) {
                    const ForcedTarget forced(target);
                    const LaneMask mask = batch.valid(packed(eight));
                    for (std::size_t lane = 0; lane < lanes; ++lane) {
                        SCOPED_TRACE(::testing::Message()
                                     << "seed " << seed << ", " << target << ", n " << points
                                     << ", m " << boxes << ", chain " << i + lane);
                        const bool expected = valid_by_oracle(eight[lane], limits, index.boxes());
                        ASSERT_EQ(mask >> lane & 1, expected);
                        valid_count += expected;
                        ++count;
                        const std::vector<Point> at = test::kernel_positions(eight[lane], limits);
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
    const auto chains = test::random_chains(7, 8 * test::scaled(25), random, limits);
    std::vector<Box> boxes = test::dust(40'000, random);
    const std::vector<Box> hard = test::hard_boxes(20, chains, limits, draw);
    boxes.insert(boxes.end(), hard.begin(), hard.end());
    const BoxIndex index(boxes);
    ChainBatch batch(6, limits, index);
    std::size_t valid_count = 0;
    for (std::size_t i = 0; i < chains.size(); i += lanes) {
        const auto eight = std::span(chains).subspan(i, lanes);
        LaneMask expected = 0;
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            const std::vector<Point> at = test::kernel_positions(eight[lane], limits);
            const bool valid = core::reference::shape_valid(eight[lane], at, limits) &&
                               !core::reference::meets_any(at, boxes);
            expected |= static_cast<LaneMask>(valid) << lane;
            valid_count += valid;
        }
        for (const std::string& target : geometry::simd::instruction_sets()) {
            const ForcedTarget forced(target);
            ASSERT_EQ(batch.valid(packed(eight)), expected)
                << "seed " << seed << ", " << target << ", chain " << i;
        }
    }
    EXPECT_GT(valid_count, chains.size() / 10);
    EXPECT_LT(valid_count, chains.size() - chains.size() / 10);
}

/// One valid chain of seven points, by which limits can be drawn a little too tight.
struct OneChain {
    OneChain() {
        Random random(2);
        row = test::valid_chains(7, 1, {}, random).at(0);
        points = test::kernel_positions(row, loose);
    }

    bool keeps(const ChainLimits& limits) const {
        const std::vector<Row> eight(lanes, row);
        return ChainBatch(6, limits, none).valid(packed(eight)) == geometry::simd::all_lanes;
    }

    /// It keeps this limit at its own value, give or take a hair, but no tighter one.
    void expect_limit(double ChainLimits::*member, double value, double outwards) const {
        ChainLimits limits = loose;
        limits.*member = value + 1e-9 * outwards;
        EXPECT_TRUE(keeps(limits));
        limits.*member = value - 1e-9 * outwards;
        EXPECT_FALSE(keeps(limits));
    }

    ChainLimits loose = chain_limits(7);
    Row row;
    std::vector<Point> points;
    BoxIndex none{{}};
};

TEST(ChainBatch, EveryLimitOfTheShapeCounts) {
    const OneChain chain;
    const Row& row = chain.row;
    const std::vector<Point>& at = chain.points;
    EXPECT_TRUE(chain.keeps(chain.loose));
    const auto minus = [](const Point& p, const Point& q) { return Point{p.x - q.x, p.y - q.y}; };
    const auto cross = [](const Point& p, const Point& q) { return p.x * q.y - p.y * q.x; };
    const Point closing = minus(at[0], at[6]);
    chain.expect_limit(&ChainLimits::min_closing_side, std::hypot(closing.x, closing.y), -1);
    chain.expect_limit(&ChainLimits::min_last_closing_turn,
                       cross(minus(at[6], at[5]), closing) / 0.05, -1);
    chain.expect_limit(&ChainLimits::min_first_closing_turn,
                       cross(closing, minus(at[1], at[0])) / 0.05, -1);
    chain.expect_limit(&ChainLimits::max_total_turn, row[7] - row[2], 1);
    double area = 0, greatest = 0;
    for (std::size_t k = 0; k < 7; ++k) area += cross(at[k], at[(k + 1) % 7]) / 2;
    for (std::size_t k = 3; k < 8; ++k) greatest = std::max(greatest, row[k] - row[k - 1]);
    chain.expect_limit(&ChainLimits::min_area, area, -1);
    chain.expect_limit(&ChainLimits::max_turn, greatest, 1);
    for (std::size_t k = 0; k < 5; ++k) {
        ChainLimits limits = chain.loose;
        limits.min_turn[k] = row[3 + k] - row[2 + k] - 1e-9;
        EXPECT_TRUE(chain.keeps(limits));
        limits.min_turn[k] += 2e-9;
        EXPECT_FALSE(chain.keeps(limits));
    }
}

TEST(ChainBatch, EverySideOfTheBoundsCountsAndIsClosed) {
    const OneChain chain;
    const auto [left, right] = std::ranges::minmax(chain.points, {}, &Point::x);
    const auto [bottom, top] = std::ranges::minmax(chain.points, {}, &Point::y);
    ChainLimits limits = chain.loose;
    limits.bounds = {{left.x, bottom.y}, {right.x, top.y}};
    EXPECT_TRUE(chain.keeps(limits)) << "the bounds are closed";
    for (double* side : {&limits.bounds.low.x, &limits.bounds.low.y, &limits.bounds.high.x,
                         &limits.bounds.high.y}) {
        const double kept = *side;
        *side += side == &limits.bounds.low.x || side == &limits.bounds.low.y ? 1e-9 : -1e-9;
        EXPECT_FALSE(chain.keeps(limits));
        *side = kept;
    }
}

}  // namespace
}  // namespace asv::geometry
