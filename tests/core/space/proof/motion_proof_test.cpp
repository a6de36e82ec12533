#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/chain/batch/chain_batch.hpp"
#include "core/search/trees/two_trees.hpp"
#include "core/space/chain_world.hpp"
#include "core/space/sampling/shape_sampler.hpp"
#include "tests/kit/batch/line_check.hpp"
#include "tests/kit/chains/configurations.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"

/// Random motions, proven by the checker that asv-solve uses and by the batch kernel, against a
/// thousand samples for every primitive step. ASV_TEST_SCALE=50 makes 100,000 motions of the two
/// thousand.

namespace asv::core {
namespace {

using test::between;
using test::for_seeds;
using test::ring;
using test::Row;
using test::scaled;

/// More than either side rounds by; far below every margin.
constexpr double rounding = 1e-12;
/// Longest motion of any ASV, about that of a tree's edge.
constexpr double longest = 0.1;

/// The limits of the world for the batch kernel, by so much looser.
core::batch::ChainLimits limits_of(const ChainWorld& world, double slack) {
    const ChainConstraints& from = world.constraints;
    core::batch::ChainLimits limits;
    limits.link = world.chain.broom_length();
    limits.bounds = geometry::grown(from.bounds, slack);
    limits.min_area = from.min_area - slack;
    limits.min_first_closing_turn = from.min_first_closing_turn - slack;
    limits.min_last_closing_turn = from.min_last_closing_turn - slack;
    limits.min_closing_side = from.min_closing_side - slack;
    for (const double turn : from.min_turn) limits.min_turn.push_back(turn - slack);
    limits.max_turn = from.max_turn + slack;
    limits.max_total_turn = 1e3;  // the closing turns see to that
    limits.anchor_lever.assign(world.chain.anchor_lever().begin(),
                               world.chain.anchor_lever().end());
    return limits;
}

struct Tally {
    std::size_t certified = 0, refuted = 0, falsely = 0;

    void count(bool proven, bool sampled_valid) {
        certified += proven;
        refuted += !proven;
        falsely += !proven && sampled_valid;
    }
    double share() const {
        return static_cast<double>(falsely) / static_cast<double>(certified + falsely);
    }
    void print(const char* who) const {
        std::printf("%s: %zu certified, %zu refuted, %zu of these falsely (%.4f %%)\n", who,
                    certified, refuted, falsely, 100 * share());
    }
};

class Place {
  public:
    Place(Rng& rng, std::size_t n, std::size_t boxes, double size)
        : world_(test::cluttered(rng, n, boxes, size), Anchor::centroid),
          checker_(world_.make_checker()),
          sampler_(checker_),
          limits_(limits_of(world_, 0)),
          loose_(limits_of(world_, rounding)),
          kernel_(n - 1, limits_, index_),
          line_check_(kernel_),
          samples_(n - 1, loose_, index_),
          rows_(n + 1) {}

    void judge_motion(Rng& rng, Tally& checker, Tally& kernel) {
        const Row from = state(rng);
        Row to = target(rng, from);
        checker_.valid(from, to);
        const double share = std::min(1.0, longest / (1e-9 + checker_.speed_bound()));
        to = between(from, to, share);
        const bool proven = checker_.valid(from, to);
        const double moved = checker_.speed_bound();
        const Row a = by_heading(from);
        Row step = by_heading(to);
        for (std::size_t k = 0; k < step.size(); ++k) step[k] -= a[k];
        const bool by_kernel = line_check_.valid(a, step, 1e-7 / std::max(moved, 1e-7));
        const bool valid = sampled_valid(a, step, moved);
        EXPECT_TRUE(valid || !proven) << "the checker certified an invalid state";
        EXPECT_TRUE(valid || !by_kernel) << "the kernel certified an invalid state";
        checker.count(proven, valid);
        kernel.count(by_kernel, valid);
    }

  private:
    Row state(Rng& rng) {
        Row row(world_.start);
        while (!sampler_.sample(rng, row)) continue;
        return row;
    }

    /// To another state, or a little off.
    Row target(Rng& rng, const Row& from) {
        Row to = state(rng);
        unwrap(to, from, WrappingAngles{2, 1});
        return between(from, to, rng.chance(0.5) ? 1 : std::pow(10, rng.uniform(-3, 0)));
    }

    /// x, y and all headings, which are linear in the configuration as their rates are.
    Row by_heading(const Row& row) const {
        Row out(row.size());
        out[0] = row[0];
        out[1] = row[1];
        world_.chain.headings(row, std::span(out).subspan(2));
        return out;
    }

    /// A thousand samples for every primitive step (fewer in a slow build), evenly; no ASV moves
    /// farther than moved.
    bool sampled_valid(const Row& from, const Row& step, double moved) {
        constexpr double primitive_step = 0.001;
        const auto in_a_step = static_cast<double>(std::min<std::size_t>(1000, scaled(1000)));
        const double count = std::ceil(moved / primitive_step * in_a_step) + 1;
        for (double first = 0; first <= count; first += geometry::simd::lanes) {
            for (std::size_t lane = 0; lane < geometry::simd::lanes; ++lane) {
                const double t = std::min(1.0, (first + static_cast<double>(lane)) / count);
                for (std::size_t k = 0; k < rows_.size(); ++k)
                    rows_[k][lane] = from[k] + t * step[k];
            }
            if (samples_.valid(rows_) != geometry::simd::all_lanes) return false;
        }
        return true;
    }

    ChainWorld world_;
    MotionChecker checker_;
    ShapeSampler sampler_;
    geometry::BoxIndex index_{world_.constraints.obstacles};
    core::batch::ChainLimits limits_, loose_;
    core::batch::ChainBatch kernel_;
    test::LineCheck line_check_;
    core::batch::ChainBatch samples_;
    std::vector<geometry::simd::Pack> rows_;
};

TEST(MotionProof, AThousandSamplesForEveryPrimitiveStepFindNothing) {
    Tally checker, kernel;
    for_seeds(1, [&](Rng& rng) {
        for (const std::size_t n : {3UL, 5UL, 7UL, 15UL}) {
            for (const std::size_t boxes : {8UL, 60UL}) {
                SCOPED_TRACE(std::to_string(n) + " ASVs, " + std::to_string(boxes) + " boxes");
                Place place(rng, n, boxes, boxes == 8 ? 0.1 : 0.04);
                for (std::size_t i = 0; i < scaled(250); ++i) {
                    SCOPED_TRACE("motion " + std::to_string(i));
                    place.judge_motion(rng, checker, kernel);
                    if (::testing::Test::HasFailure()) return;
                }
            }
        }
    });
    checker.print("checker of asv-solve");
    kernel.print("batch kernel");
    EXPECT_GT(checker.certified, checker.refuted / 10);
    EXPECT_GT(checker.refuted, checker.certified / 10);
    // Of few motions a single one would be more than that share.
    EXPECT_LE(checker.falsely, 1 + checker.certified / 1000);
    EXPECT_LE(kernel.falsely, 1 + kernel.certified / 1000);
}

}  // namespace
}  // namespace asv::core
