#include "core/space/joint_world.hpp"

#include <gtest/gtest.h>

#include "core/chain/arm_kinematics.hpp"
#include "core/model/planning_window.hpp"
#include "tests/kit/chains/configurations.hpp"

namespace asv::core {
namespace {

using test::Row;

TEST(JointWorld, EndsAreRowsOfItsSpaceWithWrappingJointsFirst) {
    PlanarArm arm{{1, 1, 1}, {{false, -1, 1}, {true}, {false, 0, 2}}, {}, {0, 0.5, 1}, {0.5, 7, 2}};
    Problem problem;
    problem.start = arm_points(arm, {0, 0}, arm.start);
    problem.goal = arm_points(arm, {0, 0}, arm.goal);
    problem.body = arm;
    problem.requirements.bounds = without_bounds();
    const JointWorld world(bounded(problem));
    EXPECT_EQ(world.wrapping_count(), 1U);
    EXPECT_EQ(world.start, (Row{0.5, 0, 1}));
    EXPECT_EQ(world.goal, (Row{7, 0.5, 2}));
    Row chain_row(world.chain.dimension());
    world.chain_row(world.start, chain_row);
    EXPECT_EQ(chain_row, (Row{0, 0, 0, 0.5, 1}));
    EXPECT_TRUE(world.within_limits(world.goal));
    EXPECT_FALSE(world.within_limits(Row{0, 1.1, 1}));
}

}  // namespace
}  // namespace asv::core
