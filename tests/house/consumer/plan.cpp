// What a robot's program does with the core alone: states a problem, solves it, checks the path.

#include <cstdio>

#include "asv/core/solve/solve.hpp"
#include "asv/core/validation/validate.hpp"

int main() {
    // Three ASVs in a right angle, to be moved past a box.
    asv::core::Problem problem;
    problem.start = {{0.10, 0.50}, {0.15, 0.50}, {0.15, 0.55}};
    problem.goal = {{0.80, 0.50}, {0.85, 0.50}, {0.85, 0.55}};
    problem.obstacles = {{{0.4, 0.3}, {0.6, 0.8}}};

    asv::core::SolveOptions options;
    options.optimize = 0;
    const asv::core::SolveResult result = asv::core::solve(problem, options);
    if (!result.solution) return 1;
    std::printf("%zu states, cost %.3f\n", result.solution->path.size(), result.solution->cost);
    return asv::core::validate(problem, *result.solution, {.continuous = true}).valid() ? 0 : 1;
}
