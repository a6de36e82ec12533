#include <chrono>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/model/problem.hpp"
#include "core/search/rrt_connect.hpp"
#include "core/search/slide_and_pull.hpp"
#include "core/search/trees/single_steps.hpp"
#include "tests/kit/seeds.hpp"
#include "tests/kit/toy_planners.hpp"

/// What the planners with a tree from either end have in common.

namespace asv::core {
namespace {

using test::goal;
using test::PointSpace;
using test::Row;
using test::start;

template <GrowthOrder... orders>
SearchResult classic(PointSpace& space, const Limits& limits, Rng& rng, const Observer& observer) {
    return rrt_connect(space, {start, goal}, {{orders...}}, limits, rng, observer);
}

SearchResult steps(PointSpace& space, const Limits& limits, Rng& rng, const Observer& observer) {
    SingleSteps<PointSpace> stepping(space, {ExtendBy::steps, 0.05});
    return rrt_connect(stepping, {start, goal}, {}, limits, rng, observer);
}

SearchResult slides(PointSpace& space, const Limits& limits, Rng& rng, const Observer& observer) {
    return slide_and_pull(space, {start, goal}, {}, limits, rng, observer);
}

using enum GrowthOrder;
const test::ToyPlanner planners[] = {
    {"RrtConnect", classic<both_to_sample, start_then_goal, goal_then_start>},
    {"BothToSample", classic<both_to_sample>},
    {"StartThenGoal", classic<start_then_goal>},
    {"GoalThenStart", classic<goal_then_start>},
    {"SingleSteps", steps},
    {"SlidePull", slides},
};

struct EachPlanner : test::ToyPlannerTest {
    using test::ToyPlannerTest::plan;

    SearchResult plan(std::vector<Box> boxes, std::uint64_t seed, const Limits& limits = {},
                      const Observer& observer = {}) const {
        PointSpace space(std::move(boxes));
        return plan(space, seed, limits, observer);
    }
};

TEST_P(EachPlanner, FindsTheDoor) {
    test::for_seeds(20, [&](Rng& rng) {
        PointSpace space(test::wall_with_door());
        test::expect_way(space, plan(space, rng.bits()));
    });
}

TEST_P(EachPlanner, GoesStraightWhereNothingIsInTheWay) {
    const SearchResult result = plan(std::vector<Box>{}, 1);
    EXPECT_EQ(result.outcome, Outcome::solved);
    EXPECT_EQ(result.iterations, 0U);
    EXPECT_EQ(result.path.size() / 2, 17U);
}

TEST_P(EachPlanner, SameSeedSamePath) {
    const SearchResult a = plan(test::wall_with_door(), 5), b = plan(test::wall_with_door(), 5);
    EXPECT_EQ(a.path, b.path);
    EXPECT_EQ(a.iterations, b.iterations);
    EXPECT_NE(a.path, plan(test::wall_with_door(), 6).path);
}

TEST_P(EachPlanner, ObserversSeeTheSearchAndDoNotChangeIt) {
    std::vector<Progress> seen;
    const SearchResult watched = plan(test::wall_with_door(), 5, {},
                                      [&](const Progress& progress) { seen.push_back(progress); });
    EXPECT_EQ(watched.path, plan(test::wall_with_door(), 5).path);
    ASSERT_FALSE(seen.empty());
    for (std::size_t i = 1; i < seen.size(); ++i) {
        EXPECT_GT(seen[i].iterations, seen[i - 1].iterations);
        EXPECT_GE(seen[i].nodes[0], seen[i - 1].nodes[0]);
        EXPECT_GE(seen[i].nodes[1], seen[i - 1].nodes[1]);
    }
}

TEST_P(EachPlanner, StopsAtItsLimits) {
    Limits limits;
    limits.max_iterations = 77;
    SearchResult result = plan(test::closed_wall(), 1, limits);
    EXPECT_EQ(result.outcome, Outcome::iterations);
    EXPECT_EQ(result.iterations, 77U);
    EXPECT_TRUE(result.path.empty());

    limits = {};
    limits.max_nodes = 100;
    result = plan(test::closed_wall(), 1, limits);
    EXPECT_EQ(result.outcome, Outcome::nodes);
    const std::size_t nodes = result.trees[0].size() + result.trees[1].size();
    EXPECT_GE(nodes, 100U);
    // One iteration adds at most two ways across a half of the square.
    EXPECT_LE(nodes, 100U + 2 * 25U);

    limits = {};
    limits.deadline = Clock::now() + std::chrono::milliseconds(20);
    EXPECT_EQ(plan(test::closed_wall(), 1, limits).outcome, Outcome::deadline);
}

TEST_P(EachPlanner, StopsWhenAsked) {
    std::stop_source source;
    Limits limits;
    limits.stop = source.get_token();
    const SearchResult result = plan(test::closed_wall(), 1, limits, [&](const Progress& progress) {
        if (progress.iterations == 10) source.request_stop();
    });
    EXPECT_EQ(result.outcome, Outcome::stopped);
    EXPECT_EQ(result.iterations, 10U);
}

TEST_P(EachPlanner, TreesHangTogether) {
    Limits limits;
    limits.max_iterations = 200;
    PointSpace space(test::closed_wall());
    const SearchResult result = plan(space, 1, limits);
    ASSERT_EQ(result.trees.size(), 2U);
    for (std::size_t side : {0U, 1U}) {
        const Tree& tree = result.trees[side];
        EXPECT_GT(tree.size(), 5U);
        EXPECT_EQ(Row(tree.row(0).begin(), tree.row(0).end()), side == 0 ? start : goal);
        EXPECT_EQ(tree.parent(0), Tree::none);
        for (std::uint32_t node = 1; node < tree.size(); ++node) {
            ASSERT_LT(tree.parent(node), node);
            ASSERT_TRUE(space.free(tree.row(tree.parent(node)), tree.row(node)));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Toy, EachPlanner, ::testing::ValuesIn(planners),
                         [](const auto& given) { return given.param.name; });

}  // namespace
}  // namespace asv::core
