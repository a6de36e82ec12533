#include "core/solve/solve.hpp"
#include "io/problem/problem_file.hpp"
#include "tests/fuzz/targets/promise.hpp"
#include "tests/fuzz/targets/targets.hpp"

namespace asv::fuzz {

namespace {

void require_reads_back(const core::Problem& problem) {
    const core::Problem again = io::parse_problem(io::format_problem(problem), "written").problem;
    require(again.start == problem.start && again.goal == problem.goal &&
                again.obstacles == problem.obstacles,
            "a problem that was written reads back to the same numbers");
}

}  // namespace

void problem(std::string_view input) {
    try {
        const core::Problem read = io::parse_problem(input, "input").problem;
        require_sound(read);
        require_reads_back(read);
        core::invalid_ends(read);
    } catch (const io::ParseError& error) {
        require_place_in(input, error);
    }
}

}  // namespace asv::fuzz
