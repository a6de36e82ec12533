#include "core/space/ladder_space.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/search/trees/single_steps.hpp"
#include "core/search/trees/two_trees.hpp"
#include "tests/kit/chains/configuration_oracle.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using test::arc;
using test::for_seeds;
using test::moved;
using test::nth;
using test::Oracle;
using test::Points;
using test::ring;
using test::Row;

constexpr std::size_t never = 1'000'000;

/// Everything off but straight extensions.
LadderOptions plain() {
    LadderOptions options;
    options.enlarge = options.ladder = false;
    return options;
}

/// Three ASVs in a bend, the last one on top, and a wide ceiling a hair above it.
struct UnderACeiling {
    explicit UnderACeiling(double turn)
        : shape(arc(3, {0.3, 0.5}, 0, turn)),
          world(test::problem(shape, moved(shape, 0.3, -0.2),
                              {{{-1, shape[2].y + 1e-4}, {2, shape[2].y + 0.1}}}),
                Anchor::first_asv) {}

    Steered steer(const LadderOptions& options, const Row& target) {
        LadderSpace space(world, options);
        visited.clear();
        const Steered outcome = space.steer(world.start, target, visited);
        Configurations rows(world.start);
        rows.insert(rows.end(), visited.begin(), visited.end());
        Oracle(world).expect_valid_path(rows);
        return outcome;
    }

    Points shape;
    ChainWorld world;
    Configurations visited;
};

TEST(LadderSpace, LadderMovesWhereTheStraightWayIsBlocked) {
    UnderACeiling scene(1.2);
    Row target(scene.world.start);
    target[0] += 0.2;
    target[1] += 0.1;
    EXPECT_EQ(scene.steer(plain(), target), Steered::trapped);
    LadderOptions ladder = plain();
    ladder.ladder = true;
    EXPECT_EQ(scene.steer(ladder, target), Steered::advanced);
    EXPECT_EQ(scene.visited[scene.visited.size() - 4], target[0]);
}

TEST(LadderSpace, EnlargedAnglesGiveWay) {
    UnderACeiling scene(1.2);
    Row target(scene.world.start);
    target[1] += 0.02;
    LadderOptions ladder = plain();
    ladder.ladder = true;
    EXPECT_EQ(scene.steer(ladder, target), Steered::trapped);
    LadderOptions enlarge = plain();
    enlarge.enlarge = true;
    EXPECT_EQ(scene.steer(enlarge, target), Steered::advanced);
    // ASV 1 has climbed, which it cannot with the bend as it was.
    EXPECT_GT(scene.visited[scene.visited.size() - 3], scene.world.start[1] + 1e-3);
}

TEST(LadderSpace, SteersStraightWhereNothingIsInTheWay) {
    UnderACeiling scene(1.2);
    Row target(scene.world.start);
    target[0] += 0.3;
    target[1] -= 0.2;
    EXPECT_EQ(scene.steer(plain(), target), Steered::reached);
    EXPECT_EQ(scene.visited, target);
}

TEST(LadderSpace, SingleStepsAreShortWhereTheChainTurnsAlone) {
    const UnderACeiling scene(1.2);
    LadderSpace space(scene.world, {});
    Row target(scene.world.start);
    target[3] -= 0.3;
    ASSERT_EQ(space.distance(scene.world.start, target), 0);
    SingleSteps<LadderSpace> stepping(space, {ExtendBy::steps, 0.001, StepNodes::each});
    Configurations rows(scene.world.start);
    EXPECT_EQ(stepping.steer(scene.world.start, target, rows), Steered::reached);
    Oracle(scene.world).expect_valid_path(rows);
    EXPECT_EQ(rows.size() / 4, stepping.steps_tried() + 1);
    for (std::size_t i = 1; i < rows.size() / 4; ++i) {
        const Points before = test::positions_of(scene.world.chain, nth(rows, 4, i - 1));
        const Points after = test::positions_of(scene.world.chain, nth(rows, 4, i));
        const double moved =
            std::hypot(after.back().x - before.back().x, after.back().y - before.back().y);
        ASSERT_LE(moved, 0.001 * std::sqrt(3))
            << "root mean square of three ASVs, one of which moves";
        ASSERT_GT(moved, 0.001);
    }
}

TEST(LadderSpace, EveryMotionIsValid) {
    for_seeds(test::scaled(60), [](Rng& rng) {
        const std::size_t sizes[] = {1, 3, 5, 7};
        const std::size_t n = sizes[rng.below(4)];
        Problem problem = test::problem(ring(n, {0.2, 0.2}, 1), ring(n, {0.8, 0.8}, 2));
        problem.obstacles = test::clutter(rng, 25, 0.08, problem);
        const ChainWorld world(problem, Anchor::first_asv);
        LadderSpace space(world, {});
        Row target(world.goal);
        if (!space.sample(rng, target)) return;
        unwrap(target, world.start, space.wrapping());
        Configurations rows;
        const Steered outcome = space.steer(world.start, target, rows);
        ASSERT_EQ(outcome == Steered::trapped, rows.empty());
        if (outcome == Steered::reached) {
            ASSERT_TRUE(std::equal(target.rbegin(), target.rend(), rows.rbegin()));
        }
        rows.insert(rows.begin(), world.start.begin(), world.start.end());
        Oracle(world).expect_valid_path(rows);
    });
}

TEST(LadderSpace, CorridorSamplesHaveTheirEndInAGap) {
    const Box lower{{0.3, 0.1}, {0.7, 0.45}}, upper{{0.3, 0.55}, {0.7, 0.9}};
    const Problem problem =
        test::problem(ring(3, {0.15, 0.5}, 0), ring(3, {0.85, 0.5}, 0), {lower, upper});
    const ChainWorld world(problem, Anchor::first_asv);
    const Box gap = geometry::grown({{0.3, 0.45}, {0.7, 0.55}}, 1e-9);
    for (const bool from_last : {false, true}) {
        LadderOptions options;
        options.stepwise = false;
        options.corridor = !from_last;
        options.corridor_reversed = from_last;
        options.widest_corridor = 0.11;  // but those at the bounds are as wide
        LadderSpace space(world, options);
        std::size_t in_gap = 0, at_bounds = 0;
        for_seeds(300, [&](Rng& rng) {
            Row row(4);
            if (!space.sample(rng, row)) return;
            const Points points = test::positions_of(world.chain, row);
            const Point& end = from_last ? points.back() : points.front();
            const bool below = end.y<0.1, above = end.y> 0.9;
            ASSERT_TRUE(geometry::contains(gap, end) || below || above) << end.x << ' ' << end.y;
            (geometry::contains(gap, end) ? in_gap : at_bounds) += 1;
        });
        EXPECT_GE(in_gap, 20U);
        EXPECT_GE(at_bounds, 20U);
    }
}

/// How many of the samples have a turn beyond the sharpest one of start and goal, 0.6 here.
std::size_t sharp_samples(const LadderOptions& options) {
    const Points shape = arc(5, {0.3, 0.3}, 0, 0.6);
    Rng rng(1);
    Problem problem = test::problem(shape, moved(shape, 0.3, 0.3));
    problem.obstacles = test::clutter(rng, 30, 0.05, problem);
    const ChainWorld world(problem, Anchor::first_asv);
    LadderSpace space(world, options);
    std::size_t sharp = 0;
    for (int i = 0; i < 3000; ++i) {
        Row row(world.start);
        if (!space.sample(rng, row)) continue;
        sharp += *std::max_element(row.begin() + 3, row.end()) > 0.6 + 1e-9;
    }
    return sharp;
}

TEST(LadderSpace, TheLimitOfTheAnglesIsLiftedWhenSamplingFails) {
    LadderOptions options;
    options.lift_after = never;
    EXPECT_EQ(sharp_samples(options), 0U);
    options.lift_after = 2;
    EXPECT_GE(sharp_samples(options), 10U);
    options.limit_angles = false;
    options.lift_after = never;
    EXPECT_GE(sharp_samples(options), 10U);
}

TEST(LadderSpace, DistanceWeighsTheHeadingAndNoTurn) {
    UnderACeiling scene(1.2);
    LadderOptions options;
    options.heading_weight = 0.5;
    LadderSpace space(scene.world, options);
    EXPECT_DOUBLE_EQ(space.distance(Row{0, 0, 0, 1}, Row{3, 4, 0, 0}), 5);
    EXPECT_DOUBLE_EQ(space.distance(Row{0, 0, 0, 1}, Row{0, 0, 2, 0}), 1);
}

}  // namespace
}  // namespace asv::core
