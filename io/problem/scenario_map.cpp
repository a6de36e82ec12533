#include "io/problem/scenario_map.hpp"

#include <algorithm>
#include <string>
#include <system_error>

#include "geometry/boxes/grid_cover.hpp"
#include "io/map/map_file.hpp"
#include "io/problem/scenario_values.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/parse_error.hpp"
#include "io/text/scanner.hpp"

namespace asv::io {
namespace {

namespace fs = std::filesystem;
using geometry::Box;
using geometry::Point;
using Pointer = JsonDocument::Pointer;

/// The path without links and dots, as far as it exists; in a browser, which has no file system, as
/// it is.
fs::path resolved(const fs::path& file) {
    std::error_code error;
    const fs::path result = fs::weakly_canonical(file, error);
    return error || result.empty() ? file : result;
}

bool is_below(const fs::path& file, const fs::path& folder) {
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first ==
           folder.end();
}

/// Where the map is that a scenario names; see docs/scenario.md for what it may name.
fs::path locate_map(const JsonDocument& document, const Pointer& at, const fs::path& folder,
                    bool anywhere) {
    const std::string name = document.text(at);
    if (name.empty() || name.find('\0') != std::string::npos)
        document.fail(at, "the name of a file");
    const std::string unless = " (unless maps are allowed anywhere)";
    if (!anywhere && fs::path(name).is_absolute())
        document.fail(at, "a path relative to the scenario" + unless);
    const fs::path file = resolved((folder.empty() ? fs::path(".") : folder) / name);
    if (!anywhere && !is_below(file, resolved(folder.empty() ? fs::path(".") : folder)))
        document.fail(at, "a file below the folder of the scenario" + unless);
    return file;
}

geometry::Grid read_grid(const JsonDocument& document, const Pointer& at, const fs::path& file,
                         double threshold) {
    try {
        return read_map(file, threshold);
    } catch (const ReadError& error) {
        document.fail(at, "a map that can be read (" + std::string(error.what()) + ")");
    }
}

double number_or(const JsonDocument& document, const Pointer& at, double otherwise, double low,
                 double high) {
    return document.has(at) ? document.number(at, low, high) : otherwise;
}

/// As ROS has it, a third number may be there: the angle of the map, which has to be 0.
Point origin_of(const JsonDocument& document, const Pointer& at) {
    if (!document.has(at)) return {0, 0};
    const std::size_t count = document.is_array(at) ? document.array(at).size() : 0;
    if (count != 2 && count != 3) document.fail(at, "a point [x, y]");
    if (count == 3) static_cast<void>(document.number(at / 2, 0, 0));
    return {any_number(document, at / 0), any_number(document, at / 1)};
}

}  // namespace

ScenarioMap read_scenario_map(const JsonDocument& document, const Pointer& at,
                              const fs::path& folder, const ReadOptions& options) {
    document.require_members(at, {"file"}, {"threshold", "cell", "origin"});
    const double cell = number_or(document, at / "cell", 1, min_positive, largest_number);
    const double threshold = number_or(document, at / "threshold", default_threshold, 0, 255);
    const Point origin = origin_of(document, at / "origin");
    ScenarioMap map;
    map.file = locate_map(document, at / "file", folder, options.maps_anywhere);
    const geometry::Grid grid = read_grid(document, at / "file", map.file, threshold);
    const auto rectangles = geometry::cover(grid, max_obstacles);
    if (rectangles.size() > max_obstacles)
        document.fail(at / "file", "a map of at most " + std::to_string(max_obstacles) +
                                       " rectangles of occupied cells");
    const auto box = [&](const geometry::CellRectangle& r) {
        const auto place = [&](double start, std::size_t cells) {
            return start + cell * static_cast<double>(cells);
        };
        return Box{{place(origin.x, r.left), place(origin.y, r.bottom)},
                   {place(origin.x, r.right), place(origin.y, r.top)}};
    };
    map.obstacles.reserve(rectangles.size());
    std::transform(rectangles.begin(), rectangles.end(), std::back_inserter(map.obstacles), box);
    map.bounds = box({0, 0, grid.width, grid.height});
    return map;
}

}  // namespace asv::io
