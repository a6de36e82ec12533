// Reads a problem and a solution and tells of every requirement whether the solution meets it.

#include <exception>
#include <iostream>

#include <asv/core/validation/validate.hpp>
#include <asv/io/problem/problem_file.hpp>
#include <asv/io/solution/solution_file.hpp>

int main(int count, char** arguments) try {
    if (count != 3) {
        std::cerr << "usage: validate_a_path PROBLEM SOLUTION\n";
        return 2;
    }
    const asv::core::Problem problem = asv::io::read_problem(arguments[1]).problem;
    const asv::core::Solution solution = asv::io::read_solution(arguments[2], problem.asv_count());

    const asv::core::ValidationReport report =
        asv::core::validate(problem, solution, {.continuous = true});
    for (const asv::core::CheckResult& check : report.checks)
        std::cout << name(check.check) << ": " << describe(check) << '\n';
    for (const asv::core::CheckResult& check : report.motion)
        std::cout << "motion, " << name(check.check) << ": " << describe(check) << '\n';
    return report.valid() ? 0 : 1;
} catch (const std::exception& error) {
    // A file that cannot be read or understood: file, line, column, what was expected.
    std::cerr << error.what() << '\n';
    return 3;
}
