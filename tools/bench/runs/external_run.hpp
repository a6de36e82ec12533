#pragma once

#include "core/benchmark/run.hpp"

namespace asv::tools {

/// Seconds after the time limit at which a program that still runs is killed.
inline constexpr double grace = 0.5;

/// A run of a planner that is another program, in a private folder for temporary files: timed from
/// outside, its solution read and judged by the validator. Whatever the program does is a result
/// (docs/asv-bench.md says which), never a fault. Throws std::system_error where the system
/// grants no process or folder. Precondition: the planner is external, and
/// hold_signals_of_supervision().
core::BenchmarkRun run_external(const core::BenchmarkPlan& plan, const core::RunPlace& place);

}  // namespace asv::tools
