// Three ASVs past a box, once by OMPL's RRT-Connect and once by the library's own planner in OMPL.

#include <iostream>
#include <memory>

#include <asv/core/validation/validate.hpp>
#include <asv/tools/ompl/asv_planner.hpp>
#include <asv/tools/ompl/ompl_problem.hpp>
#include <ompl/geometric/SimpleSetup.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>

int main() {
    asv::core::Problem problem;
    problem.start = {{0.10, 0.50}, {0.15, 0.50}, {0.15, 0.55}};
    problem.goal = {{0.80, 0.50}, {0.85, 0.50}, {0.85, 0.55}};
    problem.obstacles = {{{0.4, 0.3}, {0.6, 0.8}}};
    const asv::adaptor::OmplProblem adapted(problem);

    const ompl::base::SpaceInformationPtr information = adapted.space_information();
    const ompl::base::PlannerPtr planners[] = {
        std::make_shared<ompl::geometric::RRTConnect>(information),
        std::make_shared<asv::adaptor::AsvPlanner>(information)};
    for (const ompl::base::PlannerPtr& planner : planners) {
        ompl::geometric::SimpleSetup setup(information);
        setup.setStartAndGoalStates(adapted.start(), adapted.goal());
        setup.setOptimizationObjective(adapted.objective(asv::adaptor::Goodness::any_path));
        setup.setPlanner(planner);
        if (setup.solve(10.0) != ompl::base::PlannerStatus::EXACT_SOLUTION) return 1;

        const asv::core::Solution solution = adapted.solution(setup.getSolutionPath()).value();
        const bool valid = asv::core::validate(problem, solution, {.continuous = true}).valid();
        std::cout << planner->getName() << ": cost " << solution.cost << ", "
                  << (valid ? "valid" : "not valid") << '\n';
        if (!valid) return 1;
    }
}
