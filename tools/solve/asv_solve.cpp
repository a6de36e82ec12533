#include "tools/common/command_line.hpp"
#include "tools/common/mpi_launch.hpp"
#include "tools/solve/solve_program.hpp"

int main(int argc, char** argv) try {
    using namespace asv;
    if (const auto code = tools::hand_over_to_mpi("asv-solve", argv)) return *code;
    const auto solve = [](const tools::SolveArguments& /*arguments*/, const core::Problem& problem,
                          const core::SolveOptions& options) {
        return core::solve(problem, options);
    };
    return tools::run_solve_program(argc, argv, {solve});
} catch (...) {
    return asv::tools::report_failed_start("asv-solve");
}
