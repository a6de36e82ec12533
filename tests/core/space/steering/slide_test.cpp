#include "core/space/steering/slide.hpp"

#include <cmath>
#include <numbers>
#include <optional>

#include "core/search/trees/two_trees.hpp"
#include "core/space/sampling/shape_sampler.hpp"
#include "tests/kit/chains/configuration_oracle.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using test::for_seeds;
using test::nth;
using test::Oracle;
using test::Points;
using test::ring;
using test::Row;
using test::scaled;

struct Slider {
    explicit Slider(const Problem& problem, const SlideOptions& options = {})
        : world(problem, Anchor::centroid),
          checker(world.make_checker()),
          steering(checker, world.metric, options),
          oracle(world) {}

    Row last(const Configurations& visited) const {
        return {visited.end() - static_cast<std::ptrdiff_t>(world.chain.dimension()),
                visited.end()};
    }
    /// The rows with the one they begin at.
    Configurations whole(const Row& from, const Configurations& visited) const {
        Configurations rows(from.begin(), from.end());
        rows.insert(rows.end(), visited.begin(), visited.end());
        return rows;
    }
    std::size_t count(const Configurations& rows) const {
        return rows.size() / world.chain.dimension();
    }
    Point position(std::span<const double> row, std::size_t asv) const {
        return test::positions_of(world.chain, row)[asv];
    }

    ChainWorld world;
    MotionChecker checker;
    SlideSteering steering;
    Oracle oracle;
};

/// A tower between start and goal, which lies a little higher than its top.
Problem tower(std::size_t n) {
    return test::problem(ring(n, {0.3, 0.5}, 0), ring(n, {0.7, 0.85}, 0),
                         {{{0.45, 0}, {0.55, 0.7}}});
}

TEST(Slide, EveryMotionIsValidAndComesNearer) {
    std::size_t outcomes[3] = {0, 0, 0};
    for_seeds(scaled(60), [&](Rng& rng) {
        const std::size_t sizes[] = {1, 3, 5, 7, 15};
        const std::size_t n = sizes[rng.below(5)];
        Slider slider(test::cluttered(rng, n, 25, 0.08));
        ShapeSampler sampler(slider.checker);
        Row from(slider.world.start), to(slider.world.goal);
        if (!sampler.sample(rng, from) || !sampler.sample(rng, to)) return;
        unwrap(to, from, WrappingAngles{2, to.size() > 2 ? 1U : 0U});
        Configurations visited;
        const Steered outcome = slider.steering.slide(from, to, visited);
        ++outcomes[static_cast<std::size_t>(outcome)];
        ASSERT_EQ(outcome == Steered::trapped, visited.empty());
        if (outcome == Steered::reached) {
            ASSERT_EQ(slider.last(visited), to);
        }
        const Configurations rows = slider.whole(from, visited);
        slider.oracle.expect_valid_path(rows);
        double distance = slider.world.metric.distance(from, to) * (1 + 1e-9);
        for (std::size_t i = 1; i < slider.count(rows); ++i) {
            const double now = slider.world.metric.distance(nth(rows, from.size(), i), to);
            ASSERT_LT(now, distance);
            distance = now;
        }
    });
    EXPECT_GT(outcomes[static_cast<std::size_t>(Steered::reached)], 0U);
    EXPECT_GT(outcomes[static_cast<std::size_t>(Steered::advanced)], 0U);
}

TEST(Slide, RoundsACornerThatBlocksTheStraightMotion) {
    for (const std::size_t n : {1U, 3U, 7U, 15U}) {
        SCOPED_TRACE(std::to_string(n) + " ASVs");
        Configurations visited;
        SlideOptions straight;
        straight.slide = false;
        Slider stops(tower(n), straight);
        const Row& goal = stops.world.goal;
        EXPECT_EQ(stops.steering.slide(stops.world.start, goal, visited), Steered::advanced);
        EXPECT_LT(stops.last(visited)[0], 0.5);
        EXPECT_EQ(stops.steering.steps(), 0U);

        visited.clear();
        Slider slides(tower(n));
        EXPECT_EQ(slides.steering.slide(slides.world.start, goal, visited), Steered::reached);
        EXPECT_EQ(slides.last(visited), goal);
        EXPECT_GT(slides.steering.steps(), 0U);
        slides.oracle.expect_valid_path(slides.whole(slides.world.start, visited));
    }
}

TEST(Slide, StartingInContactItSlidesOff) {
    // The tower's side touches the start.
    Problem problem = tower(7);
    double right = 0;
    for (const Point& p : problem.start) right = std::max(right, p.x);
    problem.obstacles[0].low.x = right;
    Slider slider(problem);
    Configurations visited;
    EXPECT_EQ(slider.steering.slide(slider.world.start, slider.world.goal, visited),
              Steered::reached);
}

TEST(Slide, ATargetThatIsThereIsReachedAtOnce) {
    Slider slider(tower(3));
    Configurations visited;
    EXPECT_EQ(slider.steering.slide(slider.world.start, slider.world.start, visited),
              Steered::reached);
}

TEST(Pull, BringsTheEndNearer) {
    std::size_t reached = 0, moved = 0;
    for_seeds(scaled(60), [&](Rng& rng) {
        const std::size_t sizes[] = {1, 3, 5, 7, 15};
        const std::size_t n = sizes[rng.below(5)];
        Slider slider(test::cluttered(rng, n, 25, 0.08));
        const std::size_t asv = rng.chance(0.5) ? 0 : n - 1;
        const Row& from = slider.world.start;
        const Point target{rng.uniform(), rng.uniform()};
        Configurations visited;
        const Steered outcome = slider.steering.pull(from, asv, target, visited);
        ASSERT_EQ(outcome == Steered::trapped, visited.empty());
        const Configurations rows = slider.whole(from, visited);
        slider.oracle.expect_valid_path(rows);
        double distance = 2;
        for (std::size_t i = 0; i < slider.count(rows); ++i) {
            const Point at = slider.position(nth(rows, from.size(), i), asv);
            const double now = std::hypot(at.x - target.x, at.y - target.y);
            ASSERT_LT(now, distance);
            distance = now;
        }
        if (outcome == Steered::reached) {
            ++reached;
            ASSERT_LT(distance, SlideOptions{}.hair);
        }
        if (outcome != Steered::trapped) ++moved;
    });
    EXPECT_GT(reached, 0U);
    EXPECT_GT(moved, reached);
}

TEST(Pull, TheRestMovesLittle) {
    Slider slider(test::problem(ring(7, {0.3, 0.5}, 0), ring(7, {0.7, 0.5}, 0)));
    const Row& from = slider.world.start;
    const Point at = slider.position(from, 0);
    Configurations visited;
    const Steered outcome = slider.steering.pull(from, 0, {at.x - 0.01, at.y - 0.01}, visited);
    ASSERT_EQ(outcome, Steered::reached);
    // Moving the whole chain there would be 0.0141 in the metric.
    EXPECT_LT(slider.world.metric.distance(from, slider.last(visited)), 0.012);
}

}  // namespace
}  // namespace asv::core
