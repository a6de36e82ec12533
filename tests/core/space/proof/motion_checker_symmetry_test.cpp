#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "core/search/trees/interpolate.hpp"
#include "core/solve/planning_frame.hpp"
#include "core/space/proof/motion_checker.hpp"
#include "tests/kit/chains/motion_worlds.hpp"
#include "tests/kit/scaled.hpp"

/// The answers of the motion checker do not depend on side or direction.

namespace asv::core {
namespace {

using test::for_seeds;
using test::MotionWorld;
using test::Points;
using test::Row;
using test::scaled;

/// The answers for a motion and its image have to agree, but where it is a matter of rounding.
void expect_same_answers(MotionWorld& place, const PlanningFrame& frame, Points (*map)(Points),
                         Rng& rng) {
    const ChainWorld image(frame.problem(), Anchor::centroid);
    MotionChecker checker = image.make_checker();
    const auto image_of = [&](const Row& row) {
        Points points = map(test::positions_of(place.world.chain, row));
        if (frame.transposed())
            for (Point& p : points) std::swap(p.x, p.y);
        return test::row_of(image.chain, points);
    };
    std::size_t yes = 0, no = 0;
    for (int i = 0; i < 200; ++i) {
        const Row from = place.beginning(rng), to = place.target(rng, from);
        if (to.size() > 2 && std::abs(to[2] - from[2]) > 1) continue;
        const Row a = image_of(from);
        Row b = image_of(to);
        unwrap(b, a, WrappingAngles{2, 1});
        const bool answer = place.checker.valid(from, to);
        if (std::abs(place.oracle.lowest(from, to, 100).room) < 1e-6) continue;
        ASSERT_EQ(checker.valid(a, b), answer) << "motion " << i;
        (answer ? yes : no) += 1;
    }
    EXPECT_GT(yes, 10U);
    EXPECT_GT(no, 10U);
}

Problem image(Problem problem, Points (*map)(Points)) {
    problem.start = map(problem.start);
    problem.goal = map(problem.goal);
    for (Box& box : problem.obstacles) {
        const Points corners = map({box.low, box.high});
        box = geometry::bounds(geometry::Segment{corners[0], corners[1]});
    }
    return problem;
}

TEST(Motion, MirrorsRotationsAndTheOtherWayAlongTheChainChangeNothing) {
    Points (*const maps[])(Points) = {
        [](Points points) {
            for (Point& p : points) p.x = 1 - p.x;
            return points;
        },
        [](Points points) {
            for (Point& p : points) std::swap(p.x, p.y);
            return points;
        },
        [](Points points) {
            for (Point& p : points) p = {1 - p.y, p.x};
            return points;
        },
        test::reversed,
    };
    for_seeds(scaled(4), [&](Rng& rng) {
        for (std::size_t which = 0; which < std::size(maps); ++which) {
            SCOPED_TRACE("image " + std::to_string(which));
            MotionWorld place(rng, 7, 30, 0.05, Anchor::centroid);
            const PlanningFrame frame(image(place.world.problem, maps[which]));
            expect_same_answers(place, frame, maps[which], rng);
        }
    });
}

}  // namespace
}  // namespace asv::core
