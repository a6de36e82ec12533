#include "core/space/proof/batch_checker.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include "core/solve/planner_catalogue.hpp"
#include "core/solve/solve.hpp"
#include "core/space/chain_world.hpp"
#include "core/space/sampling/shape_sampler.hpp"
#include "core/space/straight_space.hpp"
#include "tests/kit/chains/configurations.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/geometry/forced_target.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using test::between;
using test::for_seeds;
using test::ForcedTarget;
using test::Row;
using test::scaled;
using Verdict = BatchChecker::Verdict;

struct Clutter {
    std::size_t asvs, boxes;
    double size;  ///< of the boxes
};

/// Few boxes, some that are compared one by one, and so many that the tree is searched.
constexpr Clutter clutters[] = {{3, 8, 0.1}, {5, 60, 0.04}, {7, 400, 0.02}, {15, 8, 0.1}};

/// From one valid state toward another, all the way or a part of it.
struct Motion {
    Row from, to;
};

Motion random_motion(ShapeSampler& sampler, Rng& rng, const Row& start) {
    Motion motion{start, start};
    while (!sampler.sample(rng, motion.from)) continue;
    while (!sampler.sample(rng, motion.to)) continue;
    unwrap(motion.to, motion.from, WrappingAngles{2, 1});
    motion.to = between(motion.from, motion.to, rng.uniform(0, 0.5));
    return motion;
}

TEST(BatchChecker, SettlesMotionsAsTheCheckerDoesOnEveryTarget) {
    std::array<std::size_t, 3> count{};
    for_seeds(2, [&](Rng& rng) {
        for (const auto& [asvs, boxes, size] : clutters) {
            SCOPED_TRACE(std::to_string(asvs) + " ASVs, " + std::to_string(boxes) + " boxes");
            const ChainWorld world(test::cluttered(rng, asvs, boxes, size), Anchor::centroid);
            MotionChecker checker = world.make_checker();
            ShapeSampler sampler(checker);
            BatchChecker batch(world.chain, world.constraints, world.field);
            for (std::size_t i = 0; i < scaled(300); ++i) {
                SCOPED_TRACE("motion " + std::to_string(i));
                const auto [from, to] = random_motion(sampler, rng, world.start);
                const Verdict verdict = batch.motion(from, to);
                if (verdict != Verdict::open) {
                    ASSERT_EQ(verdict == Verdict::valid, checker.valid(from, to));
                }
                ++count[static_cast<std::size_t>(verdict)];
                for (const std::string& target : geometry::simd::instruction_sets()) {
                    const ForcedTarget forced(target);
                    ASSERT_EQ(batch.motion(from, to), verdict) << target;
                }
            }
        }
    });
    const auto [valid, blocked, open] = count;
    EXPECT_GT(valid, blocked / 10);
    EXPECT_GT(blocked, valid / 10);
    EXPECT_GT(open, 0U);
    EXPECT_LT(open, (valid + blocked) / 4) << "hardly worth asking";
}

TEST(BatchChecker, TheSpaceGivesTheCheckersAnswers) {
    for_seeds(2, [&](Rng& rng) {
        for (const auto& [asvs, boxes, size] : clutters) {
            const ChainWorld world(test::cluttered(rng, asvs, boxes, size), Anchor::centroid);
            MotionChecker checker = world.make_checker();
            ShapeSampler sampler(checker);
            StraightSpace space(world);
            for (std::size_t i = 0; i < scaled(300); ++i) {
                const auto [from, to] = random_motion(sampler, rng, world.start);
                ASSERT_EQ(space.motion_valid(from, to), checker.valid(from, to)) << "motion " << i;
                ASSERT_EQ(space.motion_checks(), i + 1);
                ASSERT_GE(space.state_checks(), i + 1);
            }
        }
    });
}

TEST(BatchChecker, OneSeedGivesOnePathAndOneCountOnEveryTarget) {
    Rng rng(1);
    const Problem problem = test::cluttered(rng, 5, 60, 0.04);
    for (const char* name : {"prm-random", "rrt-star"}) {
        SolveOptions options;
        options.planner = planner_named(name);
        options.optimize = 0;
        const SolveResult expected = solve(problem, options);
        ASSERT_EQ(expected.status, SolveStatus::solved);
        for (const std::string& target : geometry::simd::instruction_sets()) {
            SCOPED_TRACE(std::string(name) + " on " + target);
            const ForcedTarget forced(target);
            const SolveResult result = solve(problem, options);
            ASSERT_EQ(result.status, SolveStatus::solved);
            EXPECT_EQ(result.statistics.state_checks, expected.statistics.state_checks);
            EXPECT_EQ(result.statistics.cost, expected.statistics.cost);
            ASSERT_EQ(result.solution->path.size(), expected.solution->path.size());
            for (std::size_t i = 0; i < result.solution->path.size(); ++i)
                ASSERT_TRUE(std::ranges::equal(result.solution->path.state(i),
                                               expected.solution->path.state(i)));
        }
    }
}

}  // namespace
}  // namespace asv::core
