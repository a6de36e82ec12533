// Three ASVs past a box: states a problem, solves it, writes both as files.

#include <iostream>

#include <asv/core/solve/solve.hpp>
#include <asv/io/problem/problem_file.hpp>
#include <asv/io/solution/solution_file.hpp>

int main() {
    asv::core::Problem problem;
    problem.start = {{0.10, 0.50}, {0.15, 0.50}, {0.15, 0.55}};
    problem.goal = {{0.80, 0.50}, {0.85, 0.50}, {0.85, 0.55}};
    problem.obstacles = {{{0.4, 0.3}, {0.6, 0.8}}};

    const asv::core::SolveResult result = asv::core::solve(problem);
    std::cout << name(result.status) << ' ' << result.reason << '\n';
    if (!result.solution) return 1;
    asv::io::write_problem("problem.txt", problem);
    asv::io::write_solution("solution.txt", *result.solution);
}
