#include "core/space/joint_space.hpp"

#include <numbers>

#include "core/model/planning_window.hpp"
#include "core/search/trees/interpolate.hpp"
#include "core/space/joint_world.hpp"
#include "tests/kit/chains/arms.hpp"
#include "tests/kit/chains/configurations.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using std::numbers::pi;
using test::for_seeds;
using test::Row;
using test::scaled;

// What is certified is free wherever one looks; what is refused comes near to something.
TEST(JointSpace, AProvenMotionIsFreeWhereverOneLooks) {
    std::size_t proven = 0, refused = 0, near_misses = 0;
    for_seeds(scaled(300), [&](Rng& rng) {
        const Problem problem = test::arm_problem(rng);
        const JointWorld world(bounded(problem));
        JointSpace space(world);
        Row from(world.start), to(world.dimension()), at(world.dimension());
        for (int motion = 0; motion < 20; ++motion) {
            for (double& angle : to) angle = rng.uniform(-pi, pi);
            unwrap(to, from, space.wrapping());
            const bool valid = space.motion_valid(from, to);
            bool free = true;
            Row chain_row(world.chain.dimension());
            for (int i = 0; i <= 400; ++i) {
                interpolate(from, to, i / 400.0, at);
                Row angles(at.size());
                for (std::size_t k = 0; k < at.size(); ++k)
                    angles[world.coordinates[k].joint] = at[k];
                const auto points = test::textbook(*problem.arm(), problem.start[0], angles);
                free = free && !test::collides(points, problem.obstacles);
            }
            if (valid) {
                ++proven;
                ASSERT_TRUE(free) << "motion " << motion;
                from = to;
            } else {
                ++refused;
                if (free) ++near_misses;
            }
        }
    });
    EXPECT_GT(proven, 100U);
    // Refused without a contact at 400 places: a graze between them, or within the margin.
    EXPECT_LT(near_misses, refused / 20);
}

TEST(JointSpace, APointMustNotTouchObstacles) {
    Problem problem;
    problem.body = PointBody{};
    problem.start = {{0.1, 0.5}};
    problem.goal = {{0.9, 0.5}};
    problem.obstacles = {{{0.4, 0.2}, {0.6, 0.8}}};
    const JointWorld world(bounded(problem));
    JointSpace space(world);
    EXPECT_FALSE(space.valid(Row{0.5, 0.5}));
    EXPECT_TRUE(space.valid(Row{0.5, 0.1}));
    EXPECT_FALSE(space.motion_valid(world.start, world.goal));
    EXPECT_TRUE(space.motion_valid(world.start, Row{0.3, 0.9}));
    Configurations visited;
    EXPECT_EQ(space.steer(world.start, world.goal, visited), Steered::advanced);
    ASSERT_EQ(visited.size(), 2U);
    EXPECT_NEAR(visited[0], 0.4, 0.0021);
    EXPECT_LT(visited[0], 0.4);
    EXPECT_EQ(visited[1], 0.5);
}

}  // namespace
}  // namespace asv::core
