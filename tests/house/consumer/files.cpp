// What a stranger does with the whole package: states a problem, solves it, writes the
// solution, reads it back and has it checked.

#include <cstdio>
#include <vector>

#include "asv/core/solve/solve.hpp"
#include "asv/core/validation/validate.hpp"
#include "asv/io/solution/solution_file.hpp"

int main(int count, char** arguments) {
    if (count != 2) return 2;
    // Three ASVs in a right angle, to be moved past a box.
    asv::core::Problem problem;
    problem.start = {{0.10, 0.50}, {0.15, 0.50}, {0.15, 0.55}};
    problem.goal = {{0.80, 0.50}, {0.85, 0.50}, {0.85, 0.55}};
    problem.obstacles = {{{0.4, 0.3}, {0.6, 0.8}}};

    asv::core::SolveOptions options;
    options.optimize = 0;
    const asv::core::SolveResult result = asv::core::solve(problem, options);
    if (!result.solution) return 1;
    asv::io::write_solution(arguments[1], *result.solution);

    const asv::core::Solution read = asv::io::read_solution(arguments[1], problem.asv_count());
    const bool same = read.path == result.solution->path;
    const bool valid = asv::core::validate(problem, read, {.continuous = true}).valid();
    std::printf("%zu states, cost %.3f\n", read.path.size(), read.cost);
    return same && valid ? 0 : 1;
}
