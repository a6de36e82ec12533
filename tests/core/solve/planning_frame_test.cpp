#include "core/solve/planning_frame.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include "core/chain/arm_kinematics.hpp"
#include "geometry/predicates/polygon.hpp"

namespace asv::core {
namespace {

/// One way of stating a problem, as the planner may meet it.
struct Form {
    BodyKind body = BodyKind::chain;
    bool reversed = false;
    bool clockwise = false;  ///< a chain's
    bool endless = false;    ///< no bounds
    double scale = 1;        ///< of all lengths of a chain

    std::string text() const {
        return std::string(body == BodyKind::chain ? "chain"
                           : body == BodyKind::arm ? "arm"
                                                   : "point") +
               (reversed ? ", reversed" : "") + (clockwise ? ", clockwise" : "") +
               (endless ? ", endless" : "") + ", scale " + std::to_string(scale);
    }
};

std::vector<Form> all_forms() {
    std::vector<Form> forms;
    for (const bool reversed : {false, true}) {
        for (const bool endless : {false, true}) {
            for (const bool clockwise : {false, true})
                for (const double scale : {1.0, 3.0, 40.0, 0.01})
                    forms.push_back({BodyKind::chain, reversed, clockwise, endless, scale});
            forms.push_back({BodyKind::arm, reversed, false, endless, 1});
            forms.push_back({BodyKind::point, reversed, false, endless, 1});
        }
    }
    return forms;
}

Problem chain_problem(const Form& form) {
    Problem problem;
    problem.start = {{0.1, 0.5}, {0.15, 0.5}, {0.15, 0.55}};
    problem.goal = {{0.8, 0.3}, {0.8, 0.35}, {0.75, 0.35}};
    problem.obstacles = {{{0.4, 0.3}, {0.6, 0.8}}};
    if (form.clockwise)
        for (auto* state : {&problem.start, &problem.goal})
            std::swap(state->front(), state->back());
    Requirements& required = problem.requirements;
    for (auto* state : {&problem.start, &problem.goal})
        for (Point& point : *state) point = {form.scale * point.x, form.scale * point.y};
    Box& box = problem.obstacles[0];
    box = {{form.scale * box.low.x, form.scale * box.low.y},
           {form.scale * box.high.x, form.scale * box.high.y}};
    required.bounds = {{0, 0}, {form.scale, form.scale}};
    for (double* length : {&required.broom_length, &required.max_step,
                           &required.area_radius_per_broom, &required.tolerance})
        *length *= form.scale;
    return problem;
}

Problem arm_problem() {
    const PlanarArm arm{{0.2, 0.1}, {{true}, {true}}, {}, {0.1, 0.2}, {1.5, -0.4}};
    Problem problem;
    problem.start = arm_points(arm, {0.5, 0.5}, arm.start);
    problem.goal = arm_points(arm, {0.5, 0.5}, arm.goal);
    problem.obstacles = {{{0.1, 0.1}, {0.2, 0.2}}};
    problem.body = arm;
    return problem;
}

Problem point_problem() {
    Problem problem;
    problem.start = {{0.1, 0.2}};
    problem.goal = {{0.8, 0.3}};
    problem.obstacles = {{{0.4, 0.3}, {0.6, 0.8}}};
    problem.body = PointBody{};
    return problem;
}

Problem stated(const Form& form) {
    Problem problem = form.body == BodyKind::chain ? chain_problem(form)
                      : form.body == BodyKind::arm ? arm_problem()
                                                   : point_problem();
    if (form.endless) problem.requirements.bounds = without_bounds();
    return problem;
}

void for_all_forms(void (*check)(const Problem& given, const PlanningFrame& frame)) {
    for (const Form& form : all_forms()) {
        SCOPED_TRACE(form.text());
        const Problem given = stated(form);
        const PlanningFrame frame(given, form.reversed);
        EXPECT_EQ(frame.reversed(), form.reversed);
        EXPECT_EQ(frame.transposed(), form.clockwise);
        check(given, frame);
    }
}

TEST(PlanningFrame, ThePlannedProblemIsBoundedCounterClockwiseAndOfTheUsualSize) {
    for_all_forms([](const Problem& given, const PlanningFrame& frame) {
        const Problem& planned = frame.problem();
        EXPECT_TRUE(planned.requirements.bounded());
        EXPECT_EQ(planned.obstacles.size(), given.obstacles.size());
        if (given.body_kind() != BodyKind::chain) {
            EXPECT_EQ(frame.unit(), 1);
            return;
        }
        EXPECT_GT(geometry::signed_area(planned.start), 0);
        EXPECT_GT(geometry::signed_area(planned.goal), 0);
        EXPECT_NEAR(planned.requirements.broom_length, 0.05, 0.025);
        EXPECT_EQ(planned.requirements.broom_length * frame.unit(),
                  given.requirements.broom_length);
        EXPECT_EQ(planned.requirements.tolerance * frame.unit(), given.requirements.tolerance);
    });
}

TEST(PlanningFrame, APathComesBackFromTheGivenStartToTheGivenGoalBitForBit) {
    for_all_forms([](const Problem& given, const PlanningFrame& frame) {
        Path planned(given.asv_count());
        planned.push_back(frame.problem().start);
        planned.push_back(frame.problem().goal);
        const Path back = frame.path_back(planned);
        ASSERT_EQ(back.size(), 2U);
        EXPECT_TRUE(std::ranges::equal(back.state(0), given.start));
        EXPECT_TRUE(std::ranges::equal(back.state(1), given.goal));
    });
}

TEST(PlanningFrame, PointsAndObstaclesComeBack) {
    for_all_forms([](const Problem& given, const PlanningFrame& frame) {
        const Box& planned = frame.problem().obstacles[0];
        EXPECT_EQ(frame.point_back(planned.low), given.obstacles[0].low);
        EXPECT_EQ(frame.point_back(planned.high), given.obstacles[0].high);
        const Box& bounds = frame.problem().requirements.bounds;
        if (!given.requirements.bounded()) return;
        EXPECT_EQ(frame.point_back(bounds.low), given.requirements.bounds.low);
        EXPECT_EQ(frame.point_back(bounds.high), given.requirements.bounds.high);
    });
}

TEST(PlanningFrame, ACostComesBackInTheUnitsOfTheGivenProblem) {
    for_all_forms([](const Problem& given, const PlanningFrame& frame) {
        EXPECT_EQ(frame.cost_back(frame.problem().requirements.broom_length),
                  given.requirements.broom_length);
        const double infinity = std::numeric_limits<double>::infinity();
        EXPECT_EQ(frame.cost_back(infinity), infinity);
    });
}

TEST(PlanningFrame, TheTreeOfTheGivenStartComesFirstAndStandsThere) {
    for_all_forms([](const Problem& given, const PlanningFrame& frame) {
        const auto trees = frame.trees_back({{TreeRoot::start, {frame.problem().start[0]}, {-1}},
                                             {TreeRoot::goal, {frame.problem().goal[0]}, {-1}}});
        ASSERT_EQ(trees.size(), 2U);
        EXPECT_EQ(trees[0].root, TreeRoot::start);
        EXPECT_EQ(trees[0].points[0], given.start[0]);
        EXPECT_EQ(trees[1].root, TreeRoot::goal);
        EXPECT_EQ(trees[1].points[0], given.goal[0]);
    });
}

TEST(PlanningFrame, ALoneTreeGrewFromTheGivenGoalWhenReversed) {
    for_all_forms([](const Problem&, const PlanningFrame& frame) {
        const auto one = frame.trees_back({{TreeRoot::start, {}, {}}});
        EXPECT_EQ(one[0].root, frame.reversed() ? TreeRoot::goal : TreeRoot::start);
        const auto roadmap = frame.trees_back({{TreeRoot::roadmap, {}, {}}});
        EXPECT_EQ(roadmap[0].root, TreeRoot::roadmap);
    });
}

TEST(PlanningFrame, AReversedArmGoesFromItsGoalAnglesToItsStartAngles) {
    const Problem given = arm_problem();
    const PlanningFrame frame(given, true);
    EXPECT_EQ(frame.problem().arm()->start, given.arm()->goal);
    EXPECT_EQ(frame.problem().arm()->goal, given.arm()->start);
}

}  // namespace
}  // namespace asv::core
