#include <chrono>
#include <numbers>
#include <ostream>
#include <stop_token>
#include <string>
#include <vector>

#include "core/search/region_bias.hpp"
#include "core/search/rrt_connect.hpp"
#include "core/search/slide_and_pull.hpp"
#include "tests/kit/toy_spaces.hpp"

namespace asv::core {
namespace {

using testing::DialSpace;
using testing::nth;
using testing::PointSpace;
using testing::Row;

const Row start{0.1, 0.1}, goal{0.9, 0.1};

/// One of the planners on a toy space.
struct Case {
    std::string name;
    SearchResult (*plan)(PointSpace&, const Limits&, Rng&, const Observer&);

    friend void PrintTo(const Case& which, std::ostream* out) { *out << which.name; }
};

template <GrowthOrder... orders>
SearchResult classic(PointSpace& space, const Limits& limits, Rng& rng, const Observer& observer) {
    return rrt_connect(space, {start, goal}, {{orders...}}, limits, rng, observer);
}

SearchResult slides(PointSpace& space, const Limits& limits, Rng& rng, const Observer& observer) {
    return slide_and_pull(space, {start, goal}, {}, limits, rng, observer);
}

using enum GrowthOrder;
const Case cases[] = {
    {"RrtConnect", classic<both_to_sample, start_then_goal, goal_then_start>},
    {"BothToSample", classic<both_to_sample>},
    {"StartThenGoal", classic<start_then_goal>},
    {"GoalThenStart", classic<goal_then_start>},
    {"SlidePull", slides},
};

struct EachPlanner : ::testing::TestWithParam<Case> {
    SearchResult plan(PointSpace& space, std::uint64_t seed, const Limits& limits = {},
                      const Observer& observer = {}) const {
        Rng rng(seed);
        return GetParam().plan(space, limits, rng, observer);
    }
    SearchResult plan(std::vector<Box> boxes, std::uint64_t seed, const Limits& limits = {},
                      const Observer& observer = {}) const {
        PointSpace space(std::move(boxes));
        return plan(space, seed, limits, observer);
    }
};

TEST_P(EachPlanner, FindsTheDoor) {
    testing::for_seeds(20, [&](Rng& rng) {
        PointSpace space(testing::wall_with_door());
        const SearchResult result = plan(space, rng.bits());
        ASSERT_EQ(result.outcome, Outcome::solved);
        const std::size_t count = result.path.size() / 2;
        EXPECT_EQ(Row(result.path.begin(), result.path.begin() + 2), start);
        EXPECT_EQ(Row(result.path.end() - 2, result.path.end()), goal);
        for (std::size_t i = 1; i < count; ++i)
            ASSERT_TRUE(space.free(nth(result.path, 2, i - 1), nth(result.path, 2, i)));
    });
}

TEST_P(EachPlanner, GoesStraightWhereNothingIsInTheWay) {
    const SearchResult result = plan(std::vector<Box>{}, 1);
    EXPECT_EQ(result.outcome, Outcome::solved);
    EXPECT_EQ(result.iterations, 0U);
    EXPECT_EQ(result.path.size() / 2, 17U);
}

TEST_P(EachPlanner, SameSeedSamePath) {
    const SearchResult a = plan(testing::wall_with_door(), 5),
                       b = plan(testing::wall_with_door(), 5);
    EXPECT_EQ(a.path, b.path);
    EXPECT_EQ(a.iterations, b.iterations);
    EXPECT_NE(a.path, plan(testing::wall_with_door(), 6).path);
}

TEST_P(EachPlanner, ObserversSeeTheSearchAndDoNotChangeIt) {
    std::vector<Progress> seen;
    const SearchResult watched = plan(testing::wall_with_door(), 5, {},
                                      [&](const Progress& progress) { seen.push_back(progress); });
    EXPECT_EQ(watched.path, plan(testing::wall_with_door(), 5).path);
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
    SearchResult result = plan(testing::closed_wall(), 1, limits);
    EXPECT_EQ(result.outcome, Outcome::iterations);
    EXPECT_EQ(result.iterations, 77U);
    EXPECT_TRUE(result.path.empty());

    limits = {};
    limits.max_nodes = 100;
    result = plan(testing::closed_wall(), 1, limits);
    EXPECT_EQ(result.outcome, Outcome::nodes);
    const std::size_t nodes = result.trees[0].size() + result.trees[1].size();
    EXPECT_GE(nodes, 100U);
    // One iteration adds at most two ways across a half of the square.
    EXPECT_LE(nodes, 100U + 2 * 25U);

    limits = {};
    limits.deadline = Clock::now() + std::chrono::milliseconds(20);
    EXPECT_EQ(plan(testing::closed_wall(), 1, limits).outcome, Outcome::deadline);
}

TEST_P(EachPlanner, StopsWhenAsked) {
    std::stop_source source;
    Limits limits;
    limits.stop = source.get_token();
    const SearchResult result =
        plan(testing::closed_wall(), 1, limits, [&](const Progress& progress) {
            if (progress.iterations == 10) source.request_stop();
        });
    EXPECT_EQ(result.outcome, Outcome::stopped);
    EXPECT_EQ(result.iterations, 10U);
}

TEST_P(EachPlanner, TreesHangTogether) {
    Limits limits;
    limits.max_iterations = 200;
    PointSpace space(testing::closed_wall());
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

INSTANTIATE_TEST_SUITE_P(Toy, EachPlanner, ::testing::ValuesIn(cases),
                         [](const auto& given) { return given.param.name; });

/// Which tree was steered: that of the start is left of the wall.
int tree_of(const Row& from) {
    return from[0] < 0.5 ? 0 : 1;
}

/// The steerings of one search through a closed wall, without the first, direct one.
std::vector<std::pair<Row, Row>> steerings(std::vector<GrowthOrder> orders,
                                           std::size_t iterations) {
    PointSpace space(testing::closed_wall());
    Limits limits;
    limits.max_iterations = iterations;
    Rng rng(2);
    rrt_connect(space, {start, goal}, {std::move(orders)}, limits, rng);
    return {space.steered.begin() + 1, space.steered.end()};
}

TEST(RrtConnect, BothToSampleGrowsBothTreesTowardTheSample) {
    const auto steered = steerings({both_to_sample}, 50);
    ASSERT_GE(steered.size(), 60U);
    for (std::size_t i = 0; i + 1 < steered.size(); i += 2) {
        EXPECT_EQ(tree_of(steered[i].first), 0);
        EXPECT_EQ(tree_of(steered[i + 1].first), 1);
        EXPECT_EQ(steered[i].second, steered[i + 1].second);
    }
}

/// One tree, `first`, grows; whenever it did, the other one is steered to a place in its half.
void expect_chase(const std::vector<std::pair<Row, Row>>& steered, int first) {
    std::size_t chases = 0;
    for (std::size_t i = 0; i < steered.size(); ++i) {
        if (tree_of(steered[i].first) == first) continue;
        ++chases;
        ASSERT_GT(i, 0U);
        EXPECT_EQ(tree_of(steered[i - 1].first), first);
        EXPECT_EQ(tree_of(steered[i].second), first);
    }
    EXPECT_GE(chases, 20U);
}

TEST(RrtConnect, OneTreeGrowsAndTheOtherChases) {
    expect_chase(steerings({start_then_goal}, 50), 0);
    expect_chase(steerings({goal_then_start}, 50), 1);
}

TEST(RrtConnect, OrdersTakeTurns) {
    PointSpace space(testing::closed_wall());
    Limits limits;
    limits.max_iterations = 40;
    std::vector<std::size_t> begins;
    Rng rng(2);
    rrt_connect(space, {start, goal}, {{goal_then_start, start_then_goal}}, limits, rng,
                [&](const Progress&) { begins.push_back(space.steered.size()); });
    ASSERT_EQ(begins.size(), 41U);
    for (std::size_t i = 0; i < 40; ++i) {
        if (begins[i] == begins[i + 1]) continue;  // the sample lay in the wall
        EXPECT_EQ(tree_of(space.steered[begins[i]].first), i % 2 == 0 ? 1 : 0);
    }
}

TEST(RrtConnect, JoinsTheTreesWithoutATurnTooMany) {
    testing::for_seeds(20, [](Rng& rng) {
        DialSpace space;
        const Row from{0, rng.uniform(-30, 30)}, to{1, rng.uniform(-30, 30)};
        const SearchResult result = rrt_connect(space, {from, to}, {}, {}, rng);
        ASSERT_EQ(result.outcome, Outcome::solved);
        const std::size_t count = result.path.size() / 2;
        EXPECT_EQ(result.path[1], from[1]);
        EXPECT_NEAR(std::remainder(result.path.back() - to[1], 2 * std::numbers::pi), 0, 1e-9);
        for (std::size_t i = 1; i < count; ++i)
            ASSERT_LE(std::abs(nth(result.path, 2, i)[1] - nth(result.path, 2, i - 1)[1]),
                      1 + 1e-9);
    });
}

TEST(SlidePull, PullsItsShareOfTheIterations) {
    for (const double share : {0.0, 0.5, 1.0}) {
        PointSpace space(testing::closed_wall());
        Limits limits;
        limits.max_iterations = 1000;
        Rng rng(1);
        SlideAndPullOptions options;
        options.pull_share = share;
        slide_and_pull(space, {start, goal}, options, limits, rng);
        // One target in ten lies in the wall and is not pulled to.
        EXPECT_NEAR(static_cast<double>(space.pulls), 900 * share, 60);
    }
}

TEST(SlidePull, TheSmallerTreeGrows) {
    PointSpace space(testing::closed_wall());
    Limits limits;
    limits.max_iterations = 500;
    Rng rng(1);
    const SearchResult result = slide_and_pull(space, {start, goal}, {}, limits, rng);
    const auto first = static_cast<double>(result.trees[0].size());
    EXPECT_NEAR(first / static_cast<double>(result.trees[1].size()), 1, 0.2);
}

TEST(SlidePull, FindsADoorSoonerAlongAWayThatLeadsThroughIt) {
    std::size_t with = 0, without = 0;
    testing::for_seeds(20, [&](Rng& rng) {
        for (const bool guided : {false, true}) {
            PointSpace space(testing::wall_with_door());
            if (guided)
                for (const Point corner : {Point{0.45, 0.91}, Point{0.55, 0.91}, Point{0.9, 0.1}})
                    for (int i = 0; i < 20; ++i) {
                        const Point from =
                            space.way.empty() ? Point{0.1, 0.1} : space.way[space.way.size() - 1];
                        space.way.push_back({from.x + (corner.x - from.x) / (20 - i),
                                             from.y + (corner.y - from.y) / (20 - i)});
                    }
            const SearchResult result = slide_and_pull(space, {start, goal}, {}, {}, rng);
            ASSERT_EQ(result.outcome, Outcome::solved);
            (guided ? with : without) += result.iterations;
        }
    });
    EXPECT_LT(with, without / 2);
}

TEST(RegionBias, FollowsATreeAlongTheWayAndNotThroughWalls) {
    // The way goes right and comes back on the other side of a wall.
    std::vector<Point> stops;
    for (int i = 0; i <= 10; ++i) stops.push_back({0.1 * i, 0.4});
    for (int i = 10; i >= 0; --i) stops.push_back({0.1 * i, 0.5});
    RegionBias bias(stops);
    PointSpace space({});
    Tree tree(space.make_index());
    const auto position = [](std::span<const double> row) { return Point{row[0], row[1]}; };
    std::uint32_t node = tree.add(Row{0, 0.4}, Tree::none);
    node = tree.add(Row{0.1, 0.44}, node);
    node = tree.add(Row{0.2, 0.46}, node);
    bias.follow(tree, position);
    Rng rng(1);
    for (int i = 0; i < 50; ++i) {
        const std::size_t region = bias.region(rng);
        EXPECT_LE(region, 2U) << "nearer to the way back, but far along it";
        EXPECT_EQ(bias.node_at(region, rng), region);
        EXPECT_EQ(bias.ahead(region, rng).y, 0.4);
    }
    EXPECT_EQ(bias.in_vain(), 50U);
    for (int i = 3; i <= 10; ++i) node = tree.add(Row{0.1 * i, 0.45}, node);
    tree.add(Row{1, 0.52}, node);
    bias.follow(tree, position);
    EXPECT_EQ(bias.in_vain(), 0U);
    std::size_t farthest = 0;
    for (int i = 0; i < 50; ++i) farthest = std::max(farthest, bias.region(rng));
    EXPECT_EQ(farthest, 11U) << "the first stop of the way back";
}

}  // namespace
}  // namespace asv::core
