#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "geometry/primitives.hpp"
#include "io/problem/reading.hpp"
#include "io/text/json/document.hpp"
#include "io/text/warning.hpp"

namespace asv::io {

/// What a map adds to a scenario.
struct ScenarioMap {
    std::vector<std::filesystem::path> files;  ///< where the map was found, and its picture
    std::vector<geometry::Box> obstacles;
    geometry::Box bounds{};
    std::vector<Warning> warnings;
};

/// Reads the member "map" of a scenario that lies in the folder. The file it names, and the picture
/// that a map.yaml of ROS names, have to be regular files and, unless the options allow more, given
/// by a relative path and, links followed, below the folder. Throws ParseError, also when there
/// would be more than max_obstacles obstacles.
ScenarioMap read_scenario_map(const JsonDocument& document, const JsonDocument::Pointer& at,
                              const std::filesystem::path& folder, const ReadOptions& options);

}  // namespace asv::io
