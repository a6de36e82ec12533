#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/benchmark/plan.hpp"
#include "io/benchmark/set/benchmark_set.hpp"
#include "io/problem/reading.hpp"
#include "tools/bench/bench_outputs.hpp"

namespace asv::tools {

/// What the command line says.
struct BenchArguments {
    std::vector<std::string> problems;  ///< see problem_arguments.hpp
    std::optional<std::string> set;     ///< pattern of problems of the benchmark set
    bool list = false;                  ///< print them, and do nothing else
    std::vector<std::string> planners;  ///< as they were given
    std::string direction = "forward";
    std::vector<std::string> from;  ///< files with earlier runs, instead of problems
    std::string resume;             ///< the journal; empty for none
    BenchOutputs outputs;
    core::BenchmarkPlan plan;  ///< all but the problems, once complete() was called
    io::ReadOptions reading;
};

void add_options(CLI::App& app, BenchArguments& arguments);

/// The problems of the set that --set chooses. Throws UsageError where there is none. Precondition:
/// --set is given.
std::vector<io::SetProblem> chosen_problems(const BenchArguments& arguments);

/// Fills in what the options do not set by themselves. Throws UsageError.
void complete(BenchArguments& arguments);

}  // namespace asv::tools
