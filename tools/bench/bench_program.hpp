#pragma once

#include <cstddef>

#include "tools/bench/runs/run_crew.hpp"

namespace asv::tools {

/// Where the runs of asv-bench take place.
struct RunSite {
    HireCrew hire;
    /// Runs side by side on one machine, where the site decides that; 0 where --jobs does.
    std::size_t jobs = 0;
};

/// The program, from its arguments to its exit code.
int run_bench_program(int argc, const char* const* argv, const RunSite& site);

}  // namespace asv::tools
