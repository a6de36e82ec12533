#pragma once

#include <string>
#include <vector>

#include "core/solve/solve.hpp"
#include "io/problem/reading.hpp"
#include "tools/common/command_line.hpp"

namespace asv::tools {

/// What asv-solve was asked for.
struct SolveArguments {
    std::string problem, solution, batch, solutions, stats, certificate, trajectory, trees;
    core::MotionLimits limits;  ///< of the trajectory; where an option says nothing, empty
    std::string planner = "auto";
    std::vector<std::string> settings;
    bool markdown = false;
    bool quiet = false;
    core::SolveOptions solve;
    io::ReadOptions reading;
    core::Clock::time_point started;  ///< when the process began
};

/// Binds the options of the program; --list-planners prints and ends it.
void add_options(CLI::App& app, SolveArguments& arguments);

/// The planner with its settings. Throws UsageError.
core::Planner chosen_planner(const SolveArguments& arguments);

/// Throws UsageError where that planner does not plan for such a body.
void require_usable_planner(const SolveArguments& arguments, core::BodyKind body);

}  // namespace asv::tools
