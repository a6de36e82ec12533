#pragma once

#include <string>

#include "core/model/problem.hpp"

namespace asv::io {

/// The problem, of whatever body, as a scenario (docs/scenario.md) that reads back to the same
/// numbers; obstacles that came from a map are among the others.
std::string format_scenario(const core::Problem& problem);

}  // namespace asv::io
