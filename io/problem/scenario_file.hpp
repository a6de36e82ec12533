#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "io/problem/problem_file.hpp"

namespace asv::io {

/// Does the text begin like a scenario, with '{'? White space and a byte order mark do not count.
bool is_scenario(std::string_view text);

/// Reads a scenario: a problem as JSON, with any of the bodies, bounds, units and maps (see
/// docs/scenario.md). Maps are looked for below the given folder. Unknown members and members given
/// twice are errors; obstacles that vanish and steps that do not suit the field are warnings.
/// Throws ParseError, which names the place by line, column and JSON path.
ProblemFile parse_scenario(std::string_view text, const std::string& name,
                           const std::filesystem::path& folder, const ReadOptions& options = {});

}  // namespace asv::io
