#include "core/space/motion_cost.hpp"

#include <cmath>
#include <numbers>

#include "tests/kit/chains/configurations.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using test::between;
using test::for_seeds;
using test::nth;
using test::Points;
using test::Row;
using test::scaled;
using test::way;

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

}  // namespace
}  // namespace asv::core
