#include "core/search/rrt_connect.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "tests/kit/seeds.hpp"
#include "tests/kit/toy_planners.hpp"

namespace asv::core {
namespace {

using test::DialSpace;
using test::goal;
using test::nth;
using test::PointSpace;
using test::Row;
using test::start;
using enum GrowthOrder;

/// Which tree was steered: that of the start is left of the wall.
int tree_of(const Row& from) {
    return from[0] < 0.5 ? 0 : 1;
}

/// The steerings of one search through a closed wall, without the first, direct one.
std::vector<std::pair<Row, Row>> steerings(std::vector<GrowthOrder> orders,
                                           std::size_t iterations) {
    PointSpace space(test::closed_wall());
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
    PointSpace space(test::closed_wall());
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
    test::for_seeds(20, [](Rng& rng) {
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

}  // namespace
}  // namespace asv::core
