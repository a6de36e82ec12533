#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "core/model/problem.hpp"

namespace asv::io {

/// The problem, of whatever body, as the members of a scenario (docs/scenario.md) that reads back
/// to the same numbers; obstacles that came from a map are among the others.
nlohmann::ordered_json scenario_json(const core::Problem& problem);

/// The same as text, one member on each line; with the unit, where it is not empty.
std::string format_scenario(const core::Problem& problem, const std::string& unit = "");

}  // namespace asv::io
