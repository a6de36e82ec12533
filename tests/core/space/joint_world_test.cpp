#include "core/space/joint_world.hpp"
#include <cmath>
#include <numbers>

#include "core/bounds/lower_bound.hpp"
#include "core/chain/arm_kinematics.hpp"
#include "core/model/cost.hpp"
#include "core/model/planning_window.hpp"
#include "core/model/planning_window.hpp"
#include "core/search/trees/interpolate.hpp"
#include "core/solve/solve.hpp"
#include "core/space/joint_space.hpp"
#include "core/validation/validate.hpp"
#include "geometry/predicates/segment_box.hpp"
#include "tests/kit/support.hpp"

namespace asv::core {
namespace {

using testing::for_seeds;
using testing::Row;
using testing::scaled;

constexpr double pi = std::numbers::pi;

PlanarArm random_arm(Rng& rng) {
    PlanarArm arm;
    const std::size_t n = 1 + rng.below(6);
    for (std::size_t i = 0; i < n; ++i) {
        arm.links.push_back(rng.uniform(0.05, 0.3));
        arm.joints.push_back({rng.chance(0.5), -pi, pi});
        arm.start.push_back(rng.uniform(-pi, pi));
        arm.goal.push_back(rng.uniform(-pi, pi));
    }
    arm.angles = rng.chance(0.5) ? AngleReference::x_axis : AngleReference::previous_link;
    return arm;
}

/// The points by the textbook and the C library.
std::vector<Point> textbook(const PlanarArm& arm, const Point& base, const Row& angles) {
    std::vector<Point> points{base};
    double heading = 0;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        heading = arm.angles == AngleReference::x_axis ? angles[i] : heading + angles[i];
        points.push_back({points.back().x + arm.links[i] * std::cos(heading),
                          points.back().y + arm.links[i] * std::sin(heading)});
    }
    return points;
}

bool collides(const std::vector<Point>& points, const std::vector<Box>& boxes) {
    for (const Box& box : boxes) {
        if (points.size() == 1 && geometry::contains(box, points[0])) return true;
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            if (geometry::meets({points[i], points[i + 1]}, box)) return true;
    }
    return false;
}

/// An arm among boxes that its start and goal do not meet.
Problem random_problem(Rng& rng) {
    Problem problem;
    PlanarArm arm = random_arm(rng);
    const Point base{rng.uniform(), rng.uniform()};
    problem.start = textbook(arm, base, arm.start);
    problem.goal = textbook(arm, base, arm.goal);
    problem.body = std::move(arm);
    problem.requirements.bounds = rng.chance(0.5) ? without_bounds() : Box{{-2, -2}, {3, 3}};
    while (problem.obstacles.size() < 15) {
        const Point low{rng.uniform(-0.5, 1.5), rng.uniform(-0.5, 1.5)};
        const Box box{low, {low.x + rng.uniform(0.01, 0.2), low.y + rng.uniform(0.01, 0.2)}};
        const std::vector<Box> grown{geometry::grown(box, 0.001)};
        if (!collides(problem.start, grown) && !collides(problem.goal, grown))
            problem.obstacles.push_back(box);
    }
    return problem;
}

TEST(Arm, ItsPointsAreThoseOfTheTextbook) {
    for_seeds(scaled(500), [](Rng& rng) {
        const PlanarArm arm = random_arm(rng);
        const Point base{rng.uniform(), rng.uniform()};
        const auto points = arm_points(arm, base, arm.start);
        const auto expected = textbook(arm, base, arm.start);
        ASSERT_EQ(points.size(), expected.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_NEAR(points[i].x, expected[i].x, 1e-14);
            EXPECT_NEAR(points[i].y, expected[i].y, 1e-14);
        }
    });
}

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

// What is certified is free wherever one looks; what is refused comes near to something.
TEST(JointSpace, AProvenMotionIsFreeWhereverOneLooks) {
    std::size_t proven = 0, refused = 0, near_misses = 0;
    for_seeds(scaled(300), [&](Rng& rng) {
        const Problem problem = random_problem(rng);
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
                const auto points = textbook(*problem.arm(), problem.start[0], angles);
                free = free && !collides(points, problem.obstacles);
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

TEST(Solve, FindsValidPathsForArmsAndPoints) {
    std::size_t solved = 0;
    for_seeds(scaled(30), [&](Rng& rng) {
        const Problem problem = random_problem(rng);
        SolveOptions options{.seed = rng.bits(), .time_limit = 2, .optimize = 0};
        options.reverse = rng.chance(0.5);
        const SolveResult result = solve(problem, options);
        if (!result.solution) return;
        ++solved;
        const auto report =
            validate(problem, *result.solution, {.tolerance = 1e-5, .continuous = true});
        for (const auto* checks : {&report.checks, &report.motion})
            for (const CheckResult& check : *checks)
                ASSERT_TRUE(check.ok()) << name(check.check) << ": " << describe(check);
        EXPECT_GE(result.solution->cost, cost_lower_bound(problem).total);
    });
    EXPECT_GT(solved, scaled(30) / 2);
}

TEST(Solve, AnArmInAnEmptyPlaneGoesStraight) {
    for_seeds(scaled(50), [](Rng& rng) {
        Problem problem = random_problem(rng);
        problem.obstacles.clear();
        problem.requirements.bounds = without_bounds();
        const PlanarArm& arm = *problem.arm();
        double straight = 0;
        for (std::size_t i = 0; i < arm.links.size(); ++i) {
            double way = arm.goal[i] - arm.start[i];
            if (arm.joints[i].wraps) way = std::remainder(way, 2 * pi);
            straight += way * way;
        }
        const SolveResult result = solve(problem, {.seed = 1, .optimize = 0});
        ASSERT_TRUE(result.solution.has_value());
        EXPECT_NEAR(result.solution->cost, std::sqrt(straight), 1e-9);
        EXPECT_NEAR(cost_lower_bound(problem).total, std::sqrt(straight), 1e-2);
    });
}

TEST(Solve, ProvesThatAPointIsLockedIn) {
    Problem problem;
    problem.body = PointBody{};
    problem.start = {{0.1, 0.5}};
    problem.goal = {{0.9, 0.5}};
    problem.obstacles = {{{0.4, -1}, {0.6, 2}}};
    const SolveResult result = solve(problem, {.seed = 1, .time_limit = 20});
    EXPECT_EQ(result.status, SolveStatus::infeasible);
    EXPECT_NE(result.reason.find("the point"), std::string::npos) << result.reason;
}

}  // namespace
}  // namespace asv::core
