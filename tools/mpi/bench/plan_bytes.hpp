#pragma once

#include <string>
#include <string_view>

#include "core/benchmark/plan.hpp"

namespace asv::tools {

/// A plan with all its problems as bytes, for another rank: the first line of a journal, and each
/// problem as a scenario.
std::string plan_bytes(const core::BenchmarkPlan& plan);

/// The plan again, to the last bit. Throws std::logic_error where a problem is not what it was.
core::BenchmarkPlan plan_of(std::string_view bytes);

}  // namespace asv::tools
