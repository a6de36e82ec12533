#pragma once

#include <cstddef>
#include <string>

#include "core/benchmark/plan.hpp"

namespace asv::tools {

/// What a planner of OMPL's begins with, behind its label.
inline constexpr const char* ompl_prefix = "ompl:";

/// A planner from "[LABEL:] ompl:NAME [PARAMETER=VALUE | --OPTION]...", where "ompl:" stands at
/// begin: asv-ompl, the program beside this one, run as any other program. Throws UsageError where
/// it is not there, since this was built without OMPL, or does not take the words, which it tells
/// on standard error.
core::BenchmarkPlanner parse_ompl_planner(const std::string& text, std::size_t begin);

}  // namespace asv::tools
