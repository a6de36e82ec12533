#include "core/shorten/shortcutter.hpp"

#include <cmath>
#include <numbers>

#include "core/model/cost.hpp"
#include "core/search/trees/two_trees.hpp"
#include "core/shorten/chain_shortener.hpp"
#include "core/shorten/hybridise.hpp"
#include "core/shorten/improve.hpp"
#include "core/space/sampling/shape_sampler.hpp"
#include "tests/kit/oracle.hpp"

namespace asv::core {
namespace {

using testing::between;
using testing::for_seeds;
using testing::nth;
using testing::Oracle;
using testing::Points;
using testing::ring;
using testing::Row;
using testing::scaled;

/// What the ASVs cover together, by very short chords.
double way(const Chain& chain, const Configurations& rows) {
    return testing::along(chain, rows, 100, [](const Points& before, const Points& after) {
        double sum = 0;
        for (std::size_t j = 0; j < after.size(); ++j)
            sum += std::hypot(after[j].x - before[j].x, after[j].y - before[j].y);
        return sum;
    });
}

/// A world with a path that wanders about in it.
struct Wanderer {
    Wanderer(Rng& rng, std::size_t n, int legs)
        : world(cluttered(rng, n), Anchor::centroid),
          checker(world.make_checker()),
          steering(checker, world.metric, {}),
          path(world.start) {
        testing::wander(checker, steering, rng, legs, path);
    }

    static Problem cluttered(Rng& rng, std::size_t n) {
        Problem problem = testing::problem(ring(n, {0.2, 0.2}, 1), ring(n, {0.8, 0.8}, 2));
        problem.obstacles = testing::clutter(rng, 15, 0.08, problem);
        return problem;
    }

    void expect_same_ends(const Configurations& better) const {
        const std::size_t d = world.chain.dimension();
        ASSERT_GE(better.size(), d);
        for (std::size_t i = 0; i < d; ++i) {
            ASSERT_EQ(better[i], path[i]);
            ASSERT_EQ(better[better.size() - d + i], path[path.size() - d + i]);
        }
    }

    ChainWorld world;
    MotionChecker checker;
    SlideSteering steering;
    Configurations path;
};

TEST(MotionCost, IsTheWayOfAllAsvs) {
    for_seeds(30, [](Rng& rng) {
        const Chain chain(1 + rng.below(10), 0.05, Anchor::first_asv);
        Configurations rows;
        for (std::size_t i = 0; i < 3 * chain.dimension(); ++i) rows.push_back(rng.uniform(-2, 2));
        const double expected = way(chain, rows);
        ASSERT_NEAR(MotionCost(chain).path(rows), expected, 2e-3 * expected);
    });
}

TEST(MotionCost, KnownMotions) {
    const Chain point(1, 0.05, Anchor::centroid), pair(2, 0.05, Anchor::first_asv);
    EXPECT_DOUBLE_EQ(MotionCost(point)(Row{0, 0}, Row{3, 4}), 5);
    EXPECT_DOUBLE_EQ(MotionCost(pair)(Row{0, 0, 1}, Row{3, 4, 1}), 10);
    EXPECT_NEAR(MotionCost(pair)(Row{0, 0, 0}, Row{0, 0, 2}), 0.1, 1e-4);
}

TEST(Cost, IsTheSumOfAllMoves) {
    Path path(2);
    EXPECT_EQ(cost(path), 0);
    path.push_back(Points{{0, 0}, {1, 0}});
    EXPECT_EQ(cost(path), 0);
    path.push_back(Points{{3, 4}, {1, 0}});
    path.push_back(Points{{3, 4}, {1, 2}});
    EXPECT_EQ(cost(path), 7);
}

TEST(Cost, LosesNothingOverAMillionSteps) {
    Path path(1);
    for (int i = 0; i <= 1'000'000; ++i) path.push_back(Points{{i % 2 == 0 ? 0.0 : 0.1, 0}});
    EXPECT_DOUBLE_EQ(cost(path), 1e5);
}

TEST(Shortcutter, KeepsEndsAndValidityAndGains) {
    for_seeds(scaled(15), [](Rng& rng) {
        const std::size_t sizes[] = {1, 3, 7};
        Wanderer wanderer(rng, sizes[rng.below(3)], 4);
        if (wanderer.path.size() < 4 * wanderer.world.chain.dimension()) return;
        Shortcutter shortcutter(wanderer.world.chain, wanderer.path);
        const Bridge straight = [&](auto from, auto to, Configurations& rows) {
            if (!wanderer.checker.valid(from, to)) return false;
            rows.assign(to.begin(), to.end());
            return true;
        };
        for (int i = 0; i < 60; ++i) {
            const double before = shortcutter.cost();
            const Configurations rows = shortcutter.path();
            if (shortcutter.attempt(straight, 0.7, rng)) {
                ASSERT_LT(shortcutter.cost(), before);
            } else {
                ASSERT_EQ(shortcutter.path(), rows);
            }
        }
        wanderer.expect_same_ends(shortcutter.path());
        Oracle(wanderer.world).expect_valid_path(shortcutter.path());
        const double expected = way(wanderer.world.chain, shortcutter.path());
        ASSERT_NEAR(shortcutter.cost(), expected, 2e-3 * expected);
    });
}

TEST(Shortcutter, PartialShortcutsKeepEndsAndValidityAndGain) {
    std::size_t gains = 0;
    for_seeds(scaled(15), [&](Rng& rng) {
        const std::size_t sizes[] = {1, 3, 7};
        Wanderer wanderer(rng, sizes[rng.below(3)], 4);
        const std::size_t d = wanderer.world.chain.dimension();
        if (wanderer.path.size() < 4 * d) return;
        Shortcutter shortcutter(wanderer.world.chain, wanderer.path);
        const auto valid = [&](auto from, auto to) { return wanderer.checker.valid(from, to); };
        for (int i = 0; i < 60; ++i) {
            const double before = shortcutter.cost();
            const Configurations rows = shortcutter.path();
            const std::size_t first = rng.below(d - 1), count = first == 0 ? 2 : 1;
            if (shortcutter.attempt_partial(first, count, valid, 0.7, rng)) {
                ++gains;
                ASSERT_LT(shortcutter.cost(), before);
            } else {
                ASSERT_EQ(shortcutter.path(), rows);
            }
        }
        wanderer.expect_same_ends(shortcutter.path());
        Oracle(wanderer.world).expect_valid_path(shortcutter.path());
    });
    EXPECT_GT(gains, 20U);
}

/// Bridges that are straight, in a plane without obstacles.
bool straight_bridge(std::span<const double>, std::span<const double> to, Configurations& between) {
    between.assign(to.begin(), to.end());
    return true;
}

TEST(Hybridise, TakesTheBetterHalfOfEach) {
    const ChainWorld world(testing::problem({{0.1, 0.5}}, {{0.9, 0.5}}), Anchor::centroid);
    const Configurations first_half_good{0.1, 0.5, 0.5, 0.5, 0.7, 0.9, 0.9, 0.5};
    const Configurations last_half_good{0.1, 0.5, 0.3, 0.1, 0.5, 0.5, 0.9, 0.5};
    MotionCost cost(world.chain);
    for (const bool swapped : {false, true}) {
        const Configurations best = hybridise(swapped ? last_half_good : first_half_good,
                                              swapped ? first_half_good : last_half_good,
                                              world.metric, cost, straight_bridge);
        EXPECT_NEAR(cost.path(best), 0.8, 1e-12);
        EXPECT_EQ(nth(best, 2, 0)[0], 0.1);
        EXPECT_EQ(best[best.size() - 2], 0.9);
    }
}

TEST(Hybridise, WithoutBridgesOrWithAnotherGoalThePathStays) {
    const ChainWorld world(testing::problem({{0.1, 0.5}}, {{0.9, 0.5}}), Anchor::centroid);
    const Configurations path{0.1, 0.5, 0.4, 0.6, 0.9, 0.5}, other{0.1, 0.5, 0.4, 0.9, 0.9, 0.5};
    MotionCost cost(world.chain);
    const Bridge none = [](auto, auto, Configurations&) { return false; };
    EXPECT_NEAR(cost.path(hybridise(path, other, world.metric, cost, none)), cost.path(path),
                1e-12);
    const Configurations elsewhere{0.1, 0.5, 0.2, 0.5};
    EXPECT_EQ(hybridise(path, elsewhere, world.metric, cost, straight_bridge), path);
}

TEST(Shortcutter, DetoursThatCostMoreAreNotTaken) {
    const Chain point(1, 0.05, Anchor::centroid);
    const Configurations bend{0, 0, 1, 0, 1, 1};
    Shortcutter shortcutter(point, bend);
    const Bridge detour = [](auto, auto to, Configurations& rows) {
        rows = {-1, -1, to[0], to[1]};
        return true;
    };
    const Bridge none = [](auto, auto, Configurations&) { return false; };
    Rng rng(1);
    for (int i = 0; i < 100; ++i) {
        EXPECT_FALSE(shortcutter.attempt(detour, 1, rng));
        EXPECT_FALSE(shortcutter.attempt(none, 1, rng));
    }
    EXPECT_EQ(shortcutter.path(), bend);
}

Configurations improve(const Configurations& path, MotionChecker& checker, const Metric& metric,
                       SlideSteering& steering, std::function<AnotherPath(Rng&)> another,
                       double work, const Limits& limits, Rng& rng, CostObserver on_better = {}) {
    ChainShortener shortener(checker, metric, steering);
    return core::improve(path, shortener,
                         {.work = work,
                          .another = std::move(another),
                          .limits = limits,
                          .on_better = std::move(on_better)},
                         rng);
}

TEST(Improve, CostNeverGrowsAndThePathStaysValid) {
    std::size_t gains = 0;
    for_seeds(scaled(15), [&](Rng& rng) {
        const std::size_t sizes[] = {1, 3, 7, 15};
        Wanderer wanderer(rng, sizes[rng.below(4)], 4);
        double last = MotionCost(wanderer.world.chain).path(wanderer.path);
        const Configurations better =
            improve(wanderer.path, wanderer.checker, wanderer.world.metric, wanderer.steering, {},
                    2e5, {}, rng, [&](double found) {
                        EXPECT_LT(found, last);
                        last = found;
                        ++gains;
                    });
        EXPECT_NEAR(MotionCost(wanderer.world.chain).path(better), last, 1e-9);
        wanderer.expect_same_ends(better);
        Oracle(wanderer.world).expect_valid_path(better);
    });
    EXPECT_GE(gains, 10U);
}

TEST(Improve, SameSeedSamePath) {
    const auto improved = [](std::uint64_t seed) {
        Rng made(3), rng(seed);
        Wanderer wanderer(made, 7, 4);
        return improve(wanderer.path, wanderer.checker, wanderer.world.metric, wanderer.steering,
                       {}, 1e5, {}, rng);
    };
    EXPECT_EQ(improved(1), improved(1));
    EXPECT_NE(improved(1), improved(2));
}

TEST(Improve, EndsWhenItHasTo) {
    Rng rng(3);
    Wanderer wanderer(rng, 7, 4);
    EXPECT_EQ(improve(wanderer.path, wanderer.checker, wanderer.world.metric, wanderer.steering, {},
                      0, {}, rng),
              wanderer.path);
    Limits expired;
    expired.deadline = Clock::now();
    EXPECT_EQ(improve(wanderer.path, wanderer.checker, wanderer.world.metric, wanderer.steering, {},
                      1e9, expired, rng),
              wanderer.path);
    std::stop_source source;
    Limits stopped;
    stopped.stop = source.get_token();
    source.request_stop();
    EXPECT_EQ(improve(wanderer.path, wanderer.checker, wanderer.world.metric, wanderer.steering, {},
                      1e9, stopped, rng),
              wanderer.path);
}

TEST(Improve, SearchesThatCountNothingComeToAnEnd) {
    Rng rng(3);
    Wanderer wanderer(rng, 7, 4);
    std::size_t searches = 0;
    const auto another = [&](Rng&) {
        ++searches;
        return AnotherPath{wanderer.path, 0};
    };
    const Configurations still(
        wanderer.path.begin(),
        wanderer.path.begin() + static_cast<std::ptrdiff_t>(wanderer.world.chain.dimension()));
    improve(still, wanderer.checker, wanderer.world.metric, wanderer.steering, another, 1e4, {},
            rng);
    EXPECT_EQ(searches, 0U) << "nothing is shorter than no way at all";
    improve(wanderer.path, wanderer.checker, wanderer.world.metric, wanderer.steering, another, 1e4,
            {}, rng);
    EXPECT_LE(searches, 1000U);
}

TEST(Improve, APathThatStaysWhereItIs) {
    Rng rng(1);
    Wanderer wanderer(rng, 3, 0);
    EXPECT_EQ(improve(wanderer.path, wanderer.checker, wanderer.world.metric, wanderer.steering, {},
                      1e4, {}, rng),
              wanderer.path);
    Configurations twice(wanderer.path);
    twice.insert(twice.end(), wanderer.path.begin(), wanderer.path.end());
    EXPECT_EQ(improve(twice, wanderer.checker, wanderer.world.metric, wanderer.steering, {}, 1e4,
                      {}, rng),
              twice);
}

}  // namespace
}  // namespace asv::core
