#include "core/solve/primitive_steps.hpp"

#include <algorithm>
#include <cmath>

#include "core/model/cost.hpp"
#include "core/search/trees/two_trees.hpp"
#include "core/space/sampling/shape_sampler.hpp"
#include "core/space/steering/slide.hpp"
#include "core/validation/validate.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/chains/wandering_path.hpp"
#include "tests/kit/check_results.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using test::between;
using test::farthest_move;
using test::for_seeds;
using test::moved;
using test::nth;
using test::Points;
using test::ring;
using test::Row;
using test::scaled;

Path steps_of(const Problem& problem, const Configurations& rows) {
    const ChainWorld world(problem, Anchor::centroid);
    MotionChecker checker = world.make_checker();
    return primitive_steps(world.problem, rows, checker);
}

void expect_steps_of(const Problem& problem, const Path& path) {
    ASSERT_TRUE(std::ranges::equal(path.state(0), problem.start));
    ASSERT_TRUE(std::ranges::equal(path.state(path.size() - 1), problem.goal));
    for (std::size_t i = 1; i < path.size(); ++i)
        ASSERT_LE(farthest_move(path.state(i - 1), path.state(i)), problem.requirements.max_step)
            << "step " << i;
    test::expect_valid(validate(problem, {path, cost(path)}, {.continuous = true}));
}

/// The integral of the fastest ASV's speed along the rows, by chords.
double fastest_way(const Chain& chain, const Configurations& rows) {
    return test::along(chain, rows, 200, farthest_move);
}

TEST(PrimitiveSteps, AStraightWayTakesNoStepTooMany) {
    for (const std::size_t n : {1U, 3U, 7U}) {
        const Points start = ring(n, {0.2, 0.2}, 0);
        const Problem problem = test::problem(start, moved(start, 0.3, 0.4));
        const ChainWorld world(problem, Anchor::centroid);
        Configurations rows(world.start);
        rows.insert(rows.end(), world.goal.begin(), world.goal.end());
        const Path path = steps_of(problem, rows);
        expect_steps_of(problem, path);
        // 0.5 in steps that fall short of 0.001 by some millionths.
        EXPECT_EQ(path.size(), 502U);
    }
}

TEST(PrimitiveSteps, AWayPointFartherOffThanBothOfItsNeighboursIsNoLongerStep) {
    // Round the end of a wall that is thinner than a step is long: out by more than a step, and
    // back.
    const Point before{0.5, 0.5}, out{0.501, 0.5003}, after{0.5, 0.5006};
    for (int i = 0; i < 100; ++i) {
        const Point start{0.35 + 1e-5 * i, 0.5}, goal{0.35, 0.5006};
        Problem problem = test::problem({start}, {goal});
        problem.obstacles = {{{0.3, 0.50027}, {0.50085, 0.50033}}};
        expect_steps_of(problem, steps_of(problem, {start.x, start.y, before.x, before.y, out.x,
                                                    out.y, after.x, after.y, goal.x, goal.y}));
        if (HasFatalFailure()) return;
    }
}

/// A path by slides among boxes, and the problem that asks for it.
struct SlidePath {
    SlidePath(Rng& rng, std::size_t n) {
        problem = test::cluttered(rng, n, 25, 0.08);
        const test::Wanderer made(rng, problem, 3);
        rows = made.path;
        const std::size_t d = made.world.chain.dimension();
        problem.goal = test::positions_of(made.world.chain, nth(rows, d, rows.size() / d - 1));
    }
    Problem problem;
    Configurations rows;
};

/// A point goes round the corner of a box, or over where it would be.
Path round_a_corner(bool with_box) {
    constexpr double gap = 1.5e-5;
    const Point start{0.35, 0.5 + gap}, corner{0.5 + gap, 0.5 + gap}, goal{0.5 + gap, 0.25};
    Problem problem = test::problem({start}, {goal});
    if (with_box) problem.obstacles = {{{0.2, 0.1}, {0.5, 0.5}}};
    const Path path = steps_of(problem, {start.x, start.y, corner.x, corner.y, goal.x, goal.y});
    expect_steps_of(problem, path);
    return path;
}

TEST(PrimitiveSteps, CutACornerOnlyWhereThatIsProven) {
    const Point corner{0.5 + 1.5e-5, 0.5 + 1.5e-5};
    const auto stops_there = [&](const Path& path) {
        return std::ranges::find(path.points(), corner) != path.points().end();
    };
    EXPECT_TRUE(stops_there(round_a_corner(true)));
    EXPECT_FALSE(stops_there(round_a_corner(false)));
}

TEST(PrimitiveSteps, RandomPathsBecomeFewValidSteps) {
    for_seeds(scaled(40), [](Rng& rng) {
        const std::size_t sizes[] = {1, 3, 5, 7, 15};
        const std::size_t n = sizes[rng.below(5)];
        const SlidePath made(rng, n);
        const Path path = steps_of(made.problem, made.rows);
        expect_steps_of(made.problem, path);
        const Chain chain(n, 0.05, Anchor::centroid);
        const double least = fastest_way(chain, made.rows) / 0.001;
        const double way_points = static_cast<double>(made.rows.size() / chain.dimension());
        EXPECT_LE(static_cast<double>(path.size() - 1), 1.0001 * least + way_points);
    });
}

TEST(PrimitiveSteps, BeginAndEndExactlyWhereAFileSays) {
    for_seeds(scaled(20), [](Rng& rng) {
        SlidePath made(rng, 7);
        for (Points* end : {&made.problem.start, &made.problem.goal})
            for (Point& p : *end) p = {std::round(p.x * 1e6) / 1e6, std::round(p.y * 1e6) / 1e6};
        for (const Points* end : {&made.problem.start, &made.problem.goal})
            if (!validate_state(made.problem, *end).valid()) return;
        const ChainWorld world(made.problem, Anchor::centroid);
        // The rows begin and end at the ends as the planner sees them.
        std::copy(world.start.begin(), world.start.end(), made.rows.begin());
        Row goal(world.goal);
        const std::size_t d = goal.size(), last = made.rows.size() / d - 1;
        if (last < 1) return;
        unwrap(goal, nth(made.rows, d, last), WrappingAngles{2, 1});
        std::copy(goal.begin(), goal.end(), made.rows.end() - static_cast<std::ptrdiff_t>(d));
        MotionChecker checker = world.make_checker();
        for (std::size_t i = 1; i <= last; ++i)
            if (!checker.valid(nth(made.rows, d, i - 1), nth(made.rows, d, i))) return;
        const Path path = steps_of(made.problem, made.rows);
        ASSERT_TRUE(std::ranges::equal(path.state(0), made.problem.start));
        ASSERT_TRUE(std::ranges::equal(path.state(path.size() - 1), made.problem.goal));
        for (std::size_t i = 1; i < path.size(); ++i)
            ASSERT_LE(farthest_move(path.state(i - 1), path.state(i)), 0.001);
        test::expect_valid(validate(made.problem, {path, cost(path)}));
    });
}

TEST(PrimitiveSteps, APathOfOneStateIsOneStep) {
    const Problem problem = test::problem(ring(3, {0.5, 0.5}, 0), ring(3, {0.5, 0.5}, 0));
    const ChainWorld world(problem, Anchor::centroid);
    const Path path = steps_of(problem, world.start);
    EXPECT_LE(path.size(), 2U);
    EXPECT_TRUE(std::ranges::equal(path.state(0), problem.start));
}

}  // namespace
}  // namespace asv::core
