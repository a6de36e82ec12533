#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "core/solve/solve.hpp"
#include "tools/solve/arguments.hpp"

namespace asv::tools {

/// Where the solving of asv-solve takes place.
struct SolveSite {
    /// As core::solve(); the options are those of the arguments, and more.
    std::function<core::SolveResult(const SolveArguments&, const core::Problem&,
                                    const core::SolveOptions&)>
        solve;
    /// What users are told of it in the end, a line; none for nothing.
    std::function<std::string()> summary = {};
    std::size_t threads = 0;  ///< where --threads says nothing; 0: one for each processor
    bool alone = true;        ///< one process for all, which can answer a batch
};

/// The program, from its arguments to its exit code.
int run_solve_program(int argc, const char* const* argv, const SolveSite& site);

}  // namespace asv::tools
