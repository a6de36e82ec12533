#include <numbers>

#include <gtest/gtest.h>

#include "core/trajectory/time_optimal.hpp"
#include "tests/kit/chains/paths.hpp"

namespace asv::test {
namespace {

using core::VehicleMotion;
using std::numbers::pi;

/// The second vehicle only goes along x.
std::vector<VehicleMotion> motions_of_the_first(const Points& places, std::vector<double> times) {
    std::vector<Points> states;
    for (std::size_t k = 0; k < places.size(); ++k)
        states.push_back({places[k], {static_cast<double>(k), 9}});
    const auto all = core::vehicle_motions({path_of(states), std::move(times)});
    std::vector<VehicleMotion> first;
    for (std::size_t k = 0; k < all.size(); k += 2) first.push_back(all[k]);
    return first;
}

TEST(VehicleMotions, PointFromTheSampleBeforeToTheOneAfter) {
    const auto motions = motions_of_the_first({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {0, 1, 2, 4});
    ASSERT_EQ(motions.size(), 4U);
    EXPECT_DOUBLE_EQ(motions[0].heading, 0);
    EXPECT_DOUBLE_EQ(motions[1].heading, pi / 4);
    EXPECT_DOUBLE_EQ(motions[2].heading, 3 * pi / 4);
    EXPECT_DOUBLE_EQ(motions[3].heading, pi);
    EXPECT_DOUBLE_EQ(motions[1].speed, std::numbers::sqrt2 / 2);
    EXPECT_DOUBLE_EQ(motions[2].speed, std::numbers::sqrt2 / 3);
}

TEST(VehicleMotions, BeginAndEndAtRest) {
    const auto motions = motions_of_the_first({{0, 0}, {1, 0}, {2, 0}}, {0, 1, 2});
    EXPECT_EQ(motions.front().speed, 0);
    EXPECT_EQ(motions[1].speed, 1);
    EXPECT_EQ(motions.back().speed, 0);
}

TEST(VehicleMotions, OneThatRestsKeepsItsHeading) {
    const auto motions =
        motions_of_the_first({{0, 0}, {0, 0}, {0, 0}, {0, -1}, {1e-12, -1}, {0, -1}, {1e-12, -1}},
                             {0, 1, 2, 3, 4, 5, 6});
    for (const VehicleMotion& motion : motions) EXPECT_NEAR(motion.heading, -pi / 2, 1e-9);
    EXPECT_EQ(motions[1].speed, 0);
    EXPECT_EQ(motions[5].speed, 0);
}

TEST(VehicleMotions, OneThatNeverMovesHasHeadingZero) {
    const auto motions = motions_of_the_first({{3, 4}, {3, 4}, {3, 4}}, {0, 1, 2});
    for (const VehicleMotion& motion : motions) {
        EXPECT_EQ(motion.heading, 0);
        EXPECT_EQ(motion.speed, 0);
    }
}

TEST(VehicleMotions, OfASingleSampleAreRest) {
    const auto motions = motions_of_the_first({{3, 4}}, {0});
    ASSERT_EQ(motions.size(), 1U);
    EXPECT_EQ(motions[0].heading, 0);
    EXPECT_EQ(motions[0].speed, 0);
}

}  // namespace
}  // namespace asv::test
