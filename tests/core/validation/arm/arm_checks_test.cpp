#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/chain/arm_kinematics.hpp"
#include "core/model/cost.hpp"
#include "core/validation/validate.hpp"

namespace asv::core {
namespace {

constexpr double pi = std::numbers::pi;

/// An arm of three links that turns its last two joints, in 100 steps.
struct Sample {
    Problem problem;
    Solution solution{Path(4), 0};
};

std::vector<double> angles_at(const PlanarArm& arm, double t) {
    std::vector<double> angles;
    for (std::size_t i = 0; i < arm.start.size(); ++i)
        angles.push_back(arm.start[i] + t * (arm.goal[i] - arm.start[i]));
    return angles;
}

Sample sample(AngleReference reference = AngleReference::previous_link) {
    Sample result;
    PlanarArm arm{{1, 0.5, 0.25},
                  {{true}, {false, -1, 4}, {false, -2, 2}},
                  reference,
                  {0.25, 0.5, 1.5},
                  {0.25, 0.75, 0.5}};
    Problem& problem = result.problem;
    problem.start = arm_points(arm, {2, 1}, arm.start);
    problem.goal = arm_points(arm, {2, 1}, arm.goal);
    problem.requirements.bounds = {{0, 0}, {5, 5}};
    problem.requirements.max_step = 0.01;
    for (int i = 0; i <= 100; ++i)
        result.solution.path.push_back(arm_points(arm, {2, 1}, angles_at(arm, i / 100.0)));
    result.solution.cost = std::hypot(0.25, 1.0);
    problem.body = std::move(arm);
    return result;
}

/// The path with one state replaced.
void replace(Sample& sample, std::size_t index, const std::vector<Point>& state) {
    Path path(sample.solution.path.asv_count());
    for (std::size_t i = 0; i < sample.solution.path.size(); ++i) {
        if (i == index)
            path.push_back(state);
        else
            path.push_back(sample.solution.path.state(i));
    }
    sample.solution.path = path;
}

std::vector<Point> state_of(const Sample& sample, std::size_t index) {
    const auto state = sample.solution.path.state(index);
    return {state.begin(), state.end()};
}

std::vector<Check> failures(const Sample& sample, bool continuous = false) {
    const auto report =
        validate(sample.problem, sample.solution, {.tolerance = 1e-5, .continuous = continuous});
    std::vector<Check> failed;
    for (const auto* checks : {&report.checks, &report.motion})
        for (const CheckResult& check : *checks)
            if (!check.ok()) failed.push_back(check.check);
    return failed;
}

using Checks = std::vector<Check>;

TEST(ValidateArm, AGoodPathMeetsEveryRequirement) {
    for (const auto reference : {AngleReference::previous_link, AngleReference::x_axis}) {
        const Sample good = sample(reference);
        const auto report = validate(good.problem, good.solution, {.continuous = true});
        Checks checked;
        for (const CheckResult& check : report.checks) checked.push_back(check.check);
        EXPECT_EQ(checked,
                  (Checks{Check::ends, Check::steps, Check::cost, Check::link_lengths, Check::base,
                          Check::joint_limits, Check::bounds, Check::collisions}));
        EXPECT_EQ(report.motion.size(), 2U);
        EXPECT_TRUE(report.valid());
        EXPECT_NEAR(report.cost, std::hypot(0.25, 1.0), 1e-12);
        EXPECT_NEAR(cost(good.problem, good.solution.path), report.cost, 1e-12);
    }
}

TEST(ValidateArm, FindsEachKindOfViolation) {
    Sample wrong = sample();
    wrong.problem.goal[3].x += 1e-4;
    EXPECT_EQ(failures(wrong), Checks{Check::ends});

    wrong = sample();
    wrong.solution.cost += 1e-4;
    EXPECT_EQ(failures(wrong), Checks{Check::cost});

    wrong = sample();
    wrong.problem.requirements.max_step = 0.001;
    EXPECT_EQ(failures(wrong), Checks{Check::steps});

    wrong = sample();
    auto state = state_of(wrong, 50);
    state[3].x += 2e-4 * std::cos(1.0);
    replace(wrong, 50, state);
    EXPECT_NE(failures(wrong), Checks{});
    const auto report = validate(wrong.problem, wrong.solution, {});
    for (const CheckResult& check : report.checks) {
        if (check.check != Check::link_lengths) continue;
        EXPECT_FALSE(check.ok());
        EXPECT_EQ(check.worst->state, 50U);
        EXPECT_EQ(check.worst->broom, std::optional<std::size_t>(2));
    }

    wrong = sample();
    state = state_of(wrong, 50);
    for (Point& p : state) p.y += 1e-4;
    replace(wrong, 50, state);
    EXPECT_EQ(failures(wrong), Checks{Check::base});

    wrong = sample();
    std::get<PlanarArm>(wrong.problem.body).joints[2] = {false, -2, 1.4};
    EXPECT_EQ(failures(wrong), Checks{Check::joint_limits});

    wrong = sample();
    wrong.problem.requirements.bounds = {{0, 0}, {3.2, 5}};
    EXPECT_EQ(failures(wrong, true), (Checks{Check::bounds, Check::bounds}));

    wrong = sample();
    const Point tip = state_of(wrong, 60)[3];
    wrong.problem.obstacles = {{{tip.x - 0.01, tip.y - 0.01}, {tip.x + 0.01, tip.y + 0.01}}};
    EXPECT_EQ(failures(wrong, true), (Checks{Check::collisions, Check::collisions}));
}

TEST(ValidateArm, AMotionMayCollideBetweenGoodStates) {
    Sample coarse = sample();
    Path path(4);
    path.push_back(coarse.solution.path.state(0));
    path.push_back(coarse.solution.path.state(100));
    const Point middle = state_of(coarse, 50)[3];
    coarse.solution.path = path;
    coarse.problem.requirements.max_step = 1;
    EXPECT_EQ(failures(coarse, true), Checks{});
    coarse.problem.obstacles = {
        {{middle.x - 0.01, middle.y - 0.01}, {middle.x + 0.01, middle.y + 0.01}}};
    EXPECT_EQ(failures(coarse), Checks{});
    EXPECT_EQ(failures(coarse, true), Checks{Check::collisions});
}

TEST(ValidateArm, AJointThatDoesNotWrapMustNotEndATurnAway) {
    Sample turned = sample();
    PlanarArm arm{{1, 0.5, 0.25}, {{true}, {false, -10, 10}, {true}}, {}, {0, 0.5, 1}, {0, 0.5, 1}};
    Problem& problem = turned.problem;
    problem.start = problem.goal = arm_points(arm, {2, 1}, arm.start);
    problem.requirements.max_step = 0.1;
    Path path(4);
    for (int i = 0; i <= 100; ++i)
        path.push_back(arm_points(arm, {2, 1}, std::vector<double>{0, 0.5 + i * pi / 50, 1}));
    turned.solution = {path, 2 * pi};
    problem.body = arm;
    EXPECT_EQ(failures(turned), Checks{Check::ends});
    arm.joints[1] = {true};
    problem.body = arm;
    EXPECT_EQ(failures(turned), Checks{});
}

TEST(ValidateArm, ACoordinateThatIsNotFiniteFails) {
    Sample wrong = sample();
    auto state = state_of(wrong, 10);
    state[1].y = std::numeric_limits<double>::quiet_NaN();
    replace(wrong, 10, state);
    const auto failed = failures(wrong, true);
    EXPECT_GE(failed.size(), 7U);
}

TEST(ValidateArm, SpeaksOfLinksAndJoints) {
    Sample wrong = sample();
    std::get<PlanarArm>(wrong.problem.body).joints[2] = {false, -2, 1.4};
    const auto report = validate_state(wrong.problem, wrong.problem.start, {});
    EXPECT_EQ(name(report.checks[2].check), "joint limits");
    EXPECT_EQ(describe(report.checks[2]), "joint 3 is past its limit by 0.1 rad");
}

TEST(ValidatePoint, MustNotTouchObstacles) {
    Problem problem;
    problem.body = PointBody{};
    problem.start = {{0.1, 0.5}};
    problem.goal = {{0.102, 0.5}};
    Solution solution{Path(1), 0.002};
    for (const double x : {0.1, 0.101, 0.102})
        solution.path.push_back(std::vector<Point>{{x, 0.5}});
    EXPECT_TRUE(validate(problem, solution, {.continuous = true}).valid());
    problem.obstacles = {{{0.1009, 0.4}, {0.1011, 0.6}}};
    const auto report = validate(problem, solution, {.continuous = true});
    EXPECT_FALSE(report.valid());
    EXPECT_EQ(describe(report.checks.back()), "the point meets obstacle 1 by 9e-05");
    // A lone ASV has no broom that could collide.
    problem.body = AsvChain{};
    for (const CheckResult& check : validate(problem, solution, {}).checks)
        EXPECT_TRUE(check.ok() || check.check != Check::collisions);
    // Between two states.
    problem.body = PointBody{};
    problem.obstacles = {{{0.1004, 0.4}, {0.1006, 0.6}}};
    EXPECT_TRUE(validate(problem, solution, {}).valid());
    EXPECT_FALSE(validate(problem, solution, {.continuous = true}).valid());
}

}  // namespace
}  // namespace asv::core
