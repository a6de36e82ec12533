#include "core/search/extensions/extensions.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/model/problem.hpp"
#include "core/search/rrt_connect.hpp"
#include "tests/kit/seeds.hpp"
#include "tests/kit/toy_planners.hpp"

namespace asv::core {
namespace {

using test::goal;
using test::PointSpace;
using test::Row;
using test::start;

const Query query{start, goal};

SearchResult plan(const ExtensionOptions& options, std::uint64_t seed) {
    PointSpace space(test::wall_with_door());
    Rng rng(seed);
    return rrt_connect(space, query, {}, {}, rng, {}, Extensions(query, options));
}

/// The seven and the plain variant of the third, each alone.
std::vector<ExtensionOptions> each_alone() {
    std::vector<ExtensionOptions> all(8);
    all[0].swap_limiter = true;
    all[1].collision_swap = true;
    all[2].exhaustion.kind = ExhaustionKind::plain;
    all[3].exhaustion.kind = ExhaustionKind::heuristic;
    all[4].neighbour_cost = true;
    all[5].passage = true;
    all[6].control_chosen = true;
    all[7].goal_bias = true;
    return all;
}

TEST(Extensions, EveryCombinationFindsTheDoor) {
    for (unsigned combination = 0; combination < 3 * 64; ++combination) {
        SCOPED_TRACE("combination " + std::to_string(combination));
        ExtensionOptions options;
        options.exhaustion.kind = static_cast<ExhaustionKind>(combination / 64);
        options.swap_limiter = combination & 1;
        options.collision_swap = combination & 2;
        options.neighbour_cost = combination & 4;
        options.passage = combination & 8;
        options.control_chosen = combination & 16;
        options.goal_bias = combination & 32;
        PointSpace space(std::vector<Box>{{{0.45, -1}, {0.55, 0.6}}});
        Limits limits;
        limits.max_iterations = 100000;
        Rng rng(combination);
        const auto result =
            rrt_connect(space, query, {}, limits, rng, {}, Extensions(query, options));
        EXPECT_EQ(result.outcome, Outcome::solved);
    }
}

TEST(Extensions, NeutralParametersChangeNothing) {
    ExtensionOptions neutral;
    neutral.swap_limiter = true;
    neutral.swap_steps = 0;
    neutral.exhaustion.kind = ExhaustionKind::heuristic;
    neutral.exhaustion.share = 0;
    neutral.neighbour_cost = true;
    neutral.quality_floor = 1;
    neutral.passage = true;
    neutral.passage_filter.displacements = 0;
    neutral.control_chosen = true;
    neutral.control_reach = std::numeric_limits<double>::infinity();
    neutral.goal_bias = true;
    neutral.goal_probability = 0;
    ExtensionOptions plain = neutral;
    plain.exhaustion.kind = ExhaustionKind::plain;
    plain.exhaustion.drop_after = std::numeric_limits<std::size_t>::max();
    test::for_seeds(10, [&](Rng& rng) {
        const std::uint64_t seed = rng.bits();
        PointSpace space(test::wall_with_door());
        Rng draws(seed);
        const SearchResult base = rrt_connect(space, query, {}, {}, draws);
        for (const ExtensionOptions& options : {ExtensionOptions{}, neutral, plain}) {
            const SearchResult same = plan(options, seed);
            EXPECT_EQ(same.path, base.path);
            EXPECT_EQ(same.iterations, base.iterations);
        }
    });
}

TEST(Extensions, EachChangesTheSearch) {
    Limits limits;
    limits.max_iterations = 2000;
    /// From where to where the trees were steered.
    const auto steered = [&](const ExtensionOptions& options) {
        PointSpace space(test::closed_wall());
        Rng rng(9);
        rrt_connect(space, query, {}, limits, rng, {}, Extensions(query, options));
        return space.steered;
    };
    const auto base = steered({});
    const auto all = each_alone();
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_TRUE(steered(all[i]) != base) << i;
}

TEST(SwapLimiter, SwapsAfterItsSteps) {
    SwapLimiter limiter(100, 0.001);
    limiter.grown(0.06);
    EXPECT_FALSE(limiter.due());
    for (int blocked = 0; blocked < 39; ++blocked) limiter.grown(0);
    EXPECT_FALSE(limiter.due());
    limiter.grown(0);
    EXPECT_TRUE(limiter.due());
    EXPECT_FALSE(limiter.due());
}

TEST(CollisionSwap, SwapsAfterACollisionOnly) {
    CollisionSwap swap(true);
    swap.grown(Steered::reached);
    EXPECT_FALSE(swap.due());
    for (const Steered blocked : {Steered::advanced, Steered::trapped}) {
        swap.grown(blocked);
        swap.grown(Steered::reached);
        EXPECT_TRUE(swap.due());
        EXPECT_FALSE(swap.due());
    }
    EXPECT_TRUE(CollisionSwap(false).due());
}

TEST(Exhaustion, FactorsAreThoseReported) {
    ExhaustionOptions options;
    options.kind = ExhaustionKind::heuristic;
    const Exhaustion heuristic(options);
    for (const std::size_t fails : {0U, 7U, 20U, 33U, 100U}) {
        const double reported = 0.9 + (0.1 / 20) * std::abs(20 - static_cast<double>(fails));
        EXPECT_NEAR(heuristic.factor(fails), reported, 1e-6);
    }
    options.kind = ExhaustionKind::plain;
    const Exhaustion plain(options);
    EXPECT_EQ(plain.factor(14), 1);
    EXPECT_EQ(plain.factor(15), std::numeric_limits<float>::infinity());
}

TEST(Exhaustion, DropsANodeUntilAllAreDropped) {
    Tree tree(PointSpace({}).make_index());
    tree.add(Row{0, 0}, Tree::none);
    tree.add(Row{1, 0}, 0);
    ExhaustionOptions options;
    options.kind = ExhaustionKind::plain;
    options.drop_after = 2;
    Exhaustion exhaustion(options);
    const Row near_root{0.1, 0};
    const auto fail = [&](std::uint32_t node) { exhaustion.grown(0, node, Steered::trapped); };
    fail(0);
    exhaustion.grown(0, 0, Steered::advanced);
    EXPECT_EQ(exhaustion.nearest(tree, 0, near_root), 0U);
    fail(0);
    EXPECT_EQ(exhaustion.nearest(tree, 0, near_root), 1U);
    EXPECT_EQ(exhaustion.nearest(tree, 1, near_root), 0U) << "the other tree's fails are its own";
    fail(1);
    fail(1);
    EXPECT_EQ(exhaustion.nearest(tree, 0, near_root), 0U);
}

TEST(NeighbourCost, KeepsByTheQualityOfTheNearestNode) {
    PointSpace space({});
    Tree tree(space.make_index());
    for (const Row& row : {start, Row{0.5, 0.4}, Row{0.5, 0.9}}) tree.add(row, Tree::none);
    const auto cost = [&](const Row& row) {
        return space.distance(row, start) + space.distance(row, goal);
    };
    const double best = space.distance(start, goal), most = cost({0.5, 0.9});
    NeighbourCost neighbour_cost(query, 0.1);
    Rng rng(1);
    const auto kept = [&](const Row& row) {
        int count = 0;
        for (int i = 0; i < 20000; ++i)
            count += neighbour_cost.accept(space, tree, 0, row, rng) ? 1 : 0;
        return count / 20000.0;
    };
    EXPECT_EQ(kept(start), 1);
    EXPECT_NEAR(kept({0.5, 0.45}), 1 - (cost({0.5, 0.4}) - best) / (most - best), 0.015);
    EXPECT_NEAR(kept({0.5, 0.95}), 0.1, 0.01);
}

TEST(ControlChosen, RefusesWhatIsFartherFromTheGoalThanTheStart) {
    PointSpace space({});
    const ControlChosen control{.reach = 1};
    EXPECT_TRUE(control.accept(space, query, start));
    EXPECT_TRUE(control.accept(space, query, Row{0.5, 0.5}));
    EXPECT_FALSE(control.accept(space, query, Row{0.05, 0.1}));
}

TEST(GoalBias, DrawsTheOtherRootInItsShare) {
    PointSpace space({});
    ExtensionOptions options;
    options.goal_bias = true;
    options.goal_probability = 0.3;
    Extensions extensions(query, options);
    const TwoTrees<PointSpace> trees(space, query);
    Rng rng(1);
    Row row(2);
    for (const int side : {0, 1}) {
        int roots = 0;
        for (int i = 0; i < 10000; ++i) {
            extensions.draw(space, trees, side, rng, row);
            roots += row == (side == 0 ? goal : start) ? 1 : 0;
        }
        EXPECT_NEAR(roots / 10000.0, 0.3, 0.02);
    }
}

}  // namespace
}  // namespace asv::core
