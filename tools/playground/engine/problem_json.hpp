#pragma once

#include "core/model/problem.hpp"
#include "tools/playground/engine/answer.hpp"

namespace asv::playground {

/// The problem of a request, a scenario without a map. Throws io::ParseError.
core::Problem problem_of(const Request& request);

/// The scenario that problem_of() understands.
Json to_json(const core::Problem& problem);

/// The scenario as text, one member on each line.
std::string format_scenario(const core::Problem& problem);

}  // namespace asv::playground
