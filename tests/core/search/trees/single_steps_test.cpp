#include "core/search/trees/single_steps.hpp"

#include <vector>

#include "core/model/problem.hpp"
#include "core/search/rrt_connect.hpp"
#include "tests/kit/seeds.hpp"
#include "tests/kit/toy_planners.hpp"

namespace asv::core {
namespace {

using test::goal;
using test::nth;
using test::PointSpace;
using test::Row;
using test::start;

constexpr double rounding = 1e-12;

SingleStepOptions steps_of(double step, StepNodes nodes = StepNodes::each) {
    return {ExtendBy::steps, step, nodes};
}

/// The right half of the square is blocked.
std::vector<Box> right_half() {
    return {{{0.5, -1}, {2, 2}}};
}

TEST(SingleSteps, GoStraightStepByStepToTheTarget) {
    test::for_seeds(20, [](Rng& rng) {
        PointSpace space({});
        SingleSteps<PointSpace> stepping(space, steps_of(0.01));
        const Row from{rng.uniform(), rng.uniform()}, to{rng.uniform(), rng.uniform()};
        Configurations visited(from);
        EXPECT_EQ(stepping.steer(from, to, visited), Steered::reached);
        const std::size_t count = visited.size() / 2 - 1;
        EXPECT_EQ(Row(visited.end() - 2, visited.end()), to);
        EXPECT_EQ(stepping.steps_tried(), count);
        EXPECT_EQ(space.motion_checks, count) << "one check for each step";
        EXPECT_TRUE(space.steered.empty());
        const double length = space.distance(from, to);
        EXPECT_LT(static_cast<double>(count - 1) * 0.01, length);
        for (std::size_t i = 1; i <= count; ++i) {
            const auto before = nth(visited, 2, i - 1), at = nth(visited, 2, i);
            EXPECT_LE(space.distance(before, at), 0.01 + rounding);
            EXPECT_NEAR(space.distance(from, at) + space.distance(at, to), length, rounding);
        }
    });
}

TEST(SingleSteps, StopBeforeTheFirstBlockedOne) {
    PointSpace space(right_half());
    SingleSteps<PointSpace> stepping(space, steps_of(0.03));
    const Row from{0.1, 0.2}, to{0.9, 0.2};
    Configurations visited;
    EXPECT_EQ(stepping.steer(from, to, visited), Steered::advanced);
    EXPECT_EQ(stepping.steps_tried(), visited.size() / 2 + 1);
    EXPECT_EQ(space.motion_checks, stepping.steps_tried());
    const Row last(visited.end() - 2, visited.end());
    EXPECT_LT(last[0], 0.5);
    EXPECT_GT(last[0], 0.5 - 0.03);

    visited.clear();
    EXPECT_EQ(stepping.steer(last, to, visited), Steered::trapped);
    EXPECT_EQ(stepping.steps_tried(), 1U);
    EXPECT_TRUE(visited.empty());
}

TEST(SingleSteps, CheckTheWayBetweenTheirEnds) {
    PointSpace space(std::vector<Box>{{{0.49, -1}, {0.51, 2}}});
    SingleSteps<PointSpace> stepping(space, steps_of(0.3));
    Configurations visited;
    EXPECT_EQ(stepping.steer(Row{0.4, 0.2}, Row{0.6, 0.2}, visited), Steered::trapped);
}

TEST(SingleSteps, TheLastOneAloneIsANodeWhereThatIsAsked) {
    for (const auto& boxes : {std::vector<Box>{}, right_half()}) {
        PointSpace space(boxes);
        SingleSteps<PointSpace> each(space, steps_of(0.01));
        SingleSteps<PointSpace> last(space, steps_of(0.01, StepNodes::last));
        Configurations all, one(start);
        EXPECT_EQ(each.steer(start, goal, all), last.steer(start, goal, one));
        EXPECT_EQ(each.steps_tried(), last.steps_tried());
        ASSERT_EQ(one.size(), 4U) << "what was there before stays";
        EXPECT_EQ(Row(one.begin(), one.begin() + 2), start);
        EXPECT_EQ(Row(one.end() - 2, one.end()), Row(all.end() - 2, all.end()));
    }
}

TEST(SingleSteps, AreSoManyAtMost) {
    PointSpace space({});
    SingleSteps<PointSpace> stepping(space, steps_of(1e-300, StepNodes::last));
    Configurations visited;
    EXPECT_EQ(stepping.steer(start, goal, visited), Steered::advanced);
    EXPECT_EQ(stepping.steps_tried(), 10000U);
}

TEST(SingleSteps, AreTheEdgesOfTheTrees) {
    PointSpace space(test::closed_wall());
    SingleSteps<PointSpace> stepping(space, steps_of(0.02));
    Limits limits;
    limits.max_iterations = 100;
    Rng rng(1);
    const SearchResult result = rrt_connect(stepping, {start, goal}, {}, limits, rng);
    for (const Tree& tree : result.trees) {
        ASSERT_GT(tree.size(), 150U);
        std::size_t in_chain = 0;
        for (std::uint32_t node = 1; node < tree.size(); ++node) {
            ASSERT_LE(space.distance(tree.row(tree.parent(node)), tree.row(node)), 0.02 + rounding);
            if (tree.parent(node) + 1 == node) ++in_chain;
        }
        EXPECT_GT(in_chain, tree.size() / 2);
    }
}

TEST(SingleSteps, FindTheWayWithTheExtensions) {
    ExtensionOptions all;
    all.swap_limiter = all.collision_swap = all.neighbour_cost = all.goal_bias = true;
    all.swap_steps = 50;
    all.exhaustion.kind = ExhaustionKind::heuristic;
    test::for_seeds(5, [&](Rng& seeds) {
        const std::uint64_t seed = seeds.bits();
        const auto plan = [&](StepNodes nodes) {
            PointSpace space(std::vector<Box>{{{0.45, -1}, {0.55, 0.6}}});
            SingleSteps<PointSpace> stepping(space, steps_of(0.01, nodes));
            Rng rng(seed);
            const Query query{start, goal};
            SearchResult result =
                rrt_connect(stepping, query, {}, {}, rng, {}, Extensions(query, all));
            test::expect_way(space, result);
            return result.path;
        };
        EXPECT_EQ(plan(StepNodes::each), plan(StepNodes::each));
        plan(StepNodes::last);
    });
}

TEST(SingleSteps, AreWhatTheSwapLimiterCounts) {
    PointSpace space(right_half());
    SingleSteps<PointSpace> stepping(space, steps_of(0.01));
    const Row from{0.1, 0.2};
    const Query query{from, goal};
    ExtensionOptions options;
    options.swap_limiter = true;
    options.swap_steps = 10;
    Extensions extensions(query, options);
    TwoTrees<SingleSteps<PointSpace>> trees(stepping, query);
    const auto grow = [&](const Row& target) {
        const std::uint32_t node = trees[0].nearest(target);
        const auto growth = trees.grow(0, node, target);
        extensions.grown(stepping, trees[0], 0, node, growth.outcome, growth.last);
    };
    grow({0.495, 0.2});  // 40 steps
    EXPECT_TRUE(extensions.swaps());
    grow({0.495, 0.289});  // 9 steps
    EXPECT_FALSE(extensions.swaps());
    grow({0.9, 0.289});  // a blocked one
    EXPECT_TRUE(extensions.swaps());
    EXPECT_FALSE(extensions.swaps());
}

}  // namespace
}  // namespace asv::core
