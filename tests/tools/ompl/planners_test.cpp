#include <algorithm>
#include <iostream>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/util/Console.h>

#include "core/validation/validate.hpp"
#include "tests/kit/files/text.hpp"
#include "tests/tools/ompl/ompl_samples.hpp"
#include "tools/ompl/asv_planner.hpp"
#include "tools/ompl/ompl_problem.hpp"
#include "tools/ompl/planner_list.hpp"

/// OMPL's planners on our problems, and ours among OMPL's.

namespace asv::test {
namespace {

using adaptor::Goodness;
using adaptor::OmplProblem;
namespace ob = ompl::base;

/// The solution path of a definition; null where there is none from the start to the goal.
const ompl::geometric::PathGeometric* exact_path(const ob::ProblemDefinition& definition) {
    if (!definition.hasExactSolution()) return nullptr;
    return dynamic_cast<const ompl::geometric::PathGeometric*>(definition.getSolutionPath().get());
}

/// Long enough for every planner on a busy machine, and an end for one that fails.
ob::PlannerTerminationCondition patience() {
    constexpr double seconds = 30;
    return ob::timedPlannerTerminationCondition(seconds);
}

/// Of the whole path, the motion between its steps included.
void expect_valid(const OmplProblem& adapted, const ompl::geometric::PathGeometric& path,
                  const core::Problem& problem, const std::string& who) {
    EXPECT_TRUE(adapted.certified(path)) << who;
    const auto solution = adapted.solution(path);
    ASSERT_TRUE(solution) << who;
    const auto report = core::validate(problem, *solution, {.continuous = true});
    EXPECT_TRUE(report.valid()) << who;
    for (const core::CheckResult& check : report.motion) EXPECT_TRUE(check.ok()) << who;
}

class QuietOmpl : public testing::Test {
  protected:
    QuietOmpl() { ompl::msg::setLogLevel(ompl::msg::LOG_ERROR); }
};
using OmplPlanners = QuietOmpl;
using AsvAsOmplPlanner = QuietOmpl;

TEST_F(OmplPlanners, EachSolvesASmallProblemByProvenMotions) {
    const core::Problem problem = past_a_box();
    const auto names = adaptor::ompl_planner_names();
    EXPECT_GE(names.size(), 8U);
    EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
    for (const std::string_view given : names) {
        const std::string name(given);
        const OmplProblem adapted(problem);
        const auto definition = adapted.definition(Goodness::any_path);
        const auto planner = adaptor::ompl_planner(name, adapted.space_information());
        planner->setProblemDefinition(definition);
        planner->setup();
        const auto begin = core::Clock::now();
        planner->solve(patience());
        std::cout << name << ": "
                  << std::chrono::duration<double>(core::Clock::now() - begin).count() << " s\n";
        const auto* path = exact_path(*definition);
        ASSERT_TRUE(path) << name;
        expect_valid(adapted, *path, problem, name);
    }
}

TEST_F(OmplPlanners, WhatIsUnknownIsToldWithWhatThereIs) {
    const auto message = [](const auto& call) -> std::string {
        try {
            call();
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "no error";
    };
    const auto information = adaptor::information_of_a_plane();
    EXPECT_TRUE(contains(message([&] { adaptor::ompl_planner("RRTTT", information); }),
                         "no planner 'RRTTT'"));
    EXPECT_TRUE(contains(message([&] { adaptor::ompl_planner("RRTTT", information); }), "KPIECE1"));
    const auto planner = adaptor::ompl_planner("RRT", information);
    EXPECT_NO_THROW(adaptor::set_parameter(*planner, "goal_bias", "0.1"));
    EXPECT_TRUE(contains(message([&] { adaptor::set_parameter(*planner, "bias", "1"); }),
                         "no parameter 'bias'; it has goal_bias"));
    EXPECT_TRUE(contains(message([&] { adaptor::set_parameter(*planner, "goal_bias", "much"); }),
                         "does not take 'much' for goal_bias"));
}

/// As users have it: OMPL's SimpleSetup around the space and the planner.
TEST_F(AsvAsOmplPlanner, SolvesInASimpleSetup) {
    for (const std::string name : {"3ASV.txt", "bodies/arm-4-workshop.json"}) {
        const core::Problem problem = testcase(name);
        const OmplProblem adapted(problem);
        ompl::geometric::SimpleSetup setup(adapted.space_information());
        setup.setStartAndGoalStates(adapted.start(), adapted.goal());
        const auto planner = std::make_shared<adaptor::AsvPlanner>(adapted.space_information());
        planner->params().setParam("optimize", "0.01");
        EXPECT_EQ(planner->optimize(), 0.01);
        setup.setPlanner(planner);
        EXPECT_EQ(setup.solve(patience()), ob::PlannerStatus::EXACT_SOLUTION) << name;
        expect_valid(adapted, setup.getSolutionPath(), problem, name);
    }
}

/// Its start and goal are OMPL's, not those of the problem that the space was made for.
TEST_F(AsvAsOmplPlanner, PlansFromOtherStates) {
    const OmplProblem adapted(past_a_box());
    const auto definition = std::make_shared<ob::ProblemDefinition>(adapted.space_information());
    definition->setStartAndGoalStates(adapted.goal(), adapted.start());
    adaptor::AsvPlanner planner(adapted.space_information());
    planner.set_optimize(0);
    planner.setProblemDefinition(definition);
    EXPECT_EQ(planner.solve(patience()), ob::PlannerStatus::EXACT_SOLUTION);
    const auto* path = exact_path(*definition);
    ASSERT_TRUE(path);
    EXPECT_TRUE(adapted.certified(*path));
    EXPECT_NEAR(adapted.space_information()->distance(path->getState(0), adapted.goal().get()), 0,
                1e-12);
}

TEST_F(AsvAsOmplPlanner, EndsWhenItIsTold) {
    const OmplProblem adapted(testcase("7ASV.txt"));
    const auto definition = adapted.definition(Goodness::any_path);
    adaptor::AsvPlanner planner(adapted.space_information());
    planner.setProblemDefinition(definition);
    EXPECT_NE(planner.solve(ob::plannerAlwaysTerminatingCondition()),
              ob::PlannerStatus::EXACT_SOLUTION);
}

}  // namespace
}  // namespace asv::test
