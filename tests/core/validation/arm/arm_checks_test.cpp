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

using std::numbers::pi;

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

TEST(ValidateArm, AContactBetweenTheTimesLookedAtFirstIsFound) {
    Sample coarse = sample();
    const Point tip = state_of(coarse, 60)[3];
    Path path(4);
    path.push_back(coarse.solution.path.state(0));
    path.push_back(coarse.solution.path.state(100));
    coarse.solution.path = path;
    coarse.problem.requirements.max_step = 1;
    coarse.problem.obstacles = {{{tip.x - 0.001, tip.y - 0.001}, {tip.x + 0.001, tip.y + 0.001}}};
    const auto report = validate(coarse.problem, coarse.solution, {.continuous = true});
    const CheckResult& collisions = report.motion.back();
    EXPECT_FALSE(collisions.ok());
    EXPECT_NEAR(collisions.worst->time.value(), 0.6, 0.01);
    EXPECT_LE(collisions.worst->room, 0);
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

}  // namespace
}  // namespace asv::core
