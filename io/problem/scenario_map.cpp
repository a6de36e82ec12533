#include "io/problem/scenario_map.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "geometry/boxes/grid_cover.hpp"
#include "io/map/map_file.hpp"
#include "io/map/ros_map.hpp"
#include "io/map/turned_grid.hpp"
#include "io/problem/scenario_values.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/parse_error.hpp"
#include "io/text/scanner.hpp"

namespace asv::io {
namespace {

namespace fs = std::filesystem;
using geometry::Box;
using geometry::Grid;
using geometry::Point;
using Pointer = JsonDocument::Pointer;

constexpr std::size_t largest_map_yaml = std::size_t{1} << 16U;  // bytes

/// Where the cells come from and where they lie.
struct Layout {
    fs::path picture;
    OccupiedGreys greys;
    double cell = 1;
    Point origin{};
    std::optional<OccupiedGreys> certain;  ///< where others are to be told as unknown
};

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

class MapReader {
  public:
    MapReader(const JsonDocument& document, const Pointer& at, const fs::path& folder,
              const ReadOptions& options)
        : document_(document),
          at_(at),
          folder_(folder.empty() ? fs::path(".") : folder),
          anywhere_(options.maps_anywhere) {}

    ScenarioMap read() {
        document_.require_members(at_, {"file"},
                                  {"threshold", "cell", "origin", "unknown", "transpose", "flip"});
        const std::string name = document_.text(at_ / "file");
        if (name.empty() || name.find('\0') != std::string::npos)
            document_.fail(at_ / "file", "the name of a file");
        const fs::path file = locate(name, folder_, "a path relative to the scenario",
                                     "a file below the folder of the scenario");
        map_.files.push_back(file);
        const std::string ending = file.extension().string();
        const bool from_ros = ending == ".yaml" || ending == ".yml";
        place_cells(from_ros ? layout_of_ros(file) : layout_of_scenario(file));
        return std::move(map_);
    }

  private:
    /// What read() gives; a file that cannot be read is a mistake of the scenario.
    template <class Read>
    auto read_or_fail(const Read& read) const {
        try {
            return read();
        } catch (const ReadError& error) {
            document_.fail(at_ / "file",
                           "a map that can be read (" + std::string(error.what()) + ")");
        }
    }

    /// Where a file is that is named from a folder; docs/scenario.md says what may be named.
    fs::path locate(const std::string& name, const fs::path& from, const std::string& relative,
                    const std::string& below) const {
        const std::string unless = " (unless maps are allowed anywhere)";
        if (!anywhere_ && fs::path(name).is_absolute())
            document_.fail(at_ / "file", relative + unless);
        const fs::path file = resolved(from / name);
        if (!anywhere_ && !is_below(file, resolved(folder_)))
            document_.fail(at_ / "file", below + unless);
        return file;
    }

    Layout layout_of_scenario(const fs::path& file) const {
        if (document_.has(at_ / "unknown"))
            document_.fail(at_ / "unknown", "no such member, but for a map.yaml of ROS");
        Layout layout{};
        layout.picture = file;
        if (document_.has(at_ / "cell"))
            layout.cell = document_.number(at_ / "cell", min_positive, largest_number);
        if (document_.has(at_ / "threshold"))
            layout.greys.brightest = document_.number(at_ / "threshold", 0, 255);
        if (document_.has(at_ / "origin")) layout.origin = origin();
        return layout;
    }

    /// As ROS has it, a third number may be there: the angle of the map, which has to be 0.
    Point origin() const {
        const Pointer at = at_ / "origin";
        const std::size_t count = document_.is_array(at) ? document_.array(at).size() : 0;
        if (count != 2 && count != 3) document_.fail(at, "a point [x, y]");
        if (count == 3) static_cast<void>(document_.number(at / 2, 0, 0));
        return {any_number(document_, at / 0), any_number(document_, at / 1)};
    }

    Layout layout_of_ros(const fs::path& file) {
        for (const char* member : {"threshold", "cell", "origin"})
            if (document_.has(at_ / member))
                document_.fail(at_ / member, "no such member, since the map.yaml tells it");
        const RosMap ros = read_or_fail([&] {
            return parse_ros_map(read_regular_file(file, largest_map_yaml), file.string());
        });
        map_.warnings = ros.warnings;
        const fs::path picture =
            locate(ros.image, file.parent_path(), "a map.yaml whose image is a relative path",
                   "a map.yaml whose image is below the folder of the scenario");
        map_.files.push_back(picture);
        const std::optional<bool> unknown = unknown_is_obstacle();
        Layout layout{
            picture, ros.occupied(unknown.value_or(true)), ros.resolution, ros.origin, {}};
        if (!unknown) layout.certain = ros.occupied(false);
        return layout;
    }

    /// None where the scenario does not say so.
    std::optional<bool> unknown_is_obstacle() const {
        const Pointer at = at_ / "unknown";
        if (!document_.has(at)) return std::nullopt;
        const std::string word = document_.text(at);
        if (word != "obstacle" && word != "free") document_.fail(at, "\"obstacle\" or \"free\"");
        return word == "obstacle";
    }

    void warn_of_unknown(const Grid& grid, const Grid& certain) {
        const auto occupied = [](const Grid& cells) {
            return std::count(cells.cells.begin(), cells.cells.end(), 1);
        };
        if (const auto unknown = occupied(grid) - occupied(certain); unknown > 0)
            map_.warnings.push_back(document_.warning(
                at_, "unknown cells (" + std::to_string(unknown) +
                         ") are taken for obstacles, which a member \"unknown\" can say"));
    }

    Grid read_grid(const fs::path& picture, const OccupiedGreys& greys) const {
        return read_or_fail([&] { return read_map(picture, greys); });
    }

    void place_cells(const Layout& layout) {
        Grid grid = read_grid(layout.picture, layout.greys);
        if (layout.certain) warn_of_unknown(grid, read_grid(layout.picture, *layout.certain));
        if (is_wanted("transpose")) grid = transposed(grid);
        if (is_wanted("flip")) grid = flipped(grid);
        const auto rectangles = geometry::cover(grid, max_obstacles);
        if (rectangles.size() > max_obstacles)
            document_.fail(at_ / "file", "a map of at most " + std::to_string(max_obstacles) +
                                             " rectangles of occupied cells");
        const auto box = [&](const geometry::CellRectangle& r) {
            const auto place = [&](double start, std::size_t cells) {
                return start + layout.cell * static_cast<double>(cells);
            };
            return Box{{place(layout.origin.x, r.left), place(layout.origin.y, r.bottom)},
                       {place(layout.origin.x, r.right), place(layout.origin.y, r.top)}};
        };
        map_.obstacles.reserve(rectangles.size());
        std::transform(rectangles.begin(), rectangles.end(), std::back_inserter(map_.obstacles),
                       box);
        map_.bounds = box({0, 0, grid.width, grid.height});
    }

    bool is_wanted(const char* member) const {
        return document_.has(at_ / member) && document_.boolean(at_ / member);
    }

    const JsonDocument& document_;
    const Pointer at_;
    const fs::path folder_;
    bool anywhere_;
    ScenarioMap map_;
};

}  // namespace

ScenarioMap read_scenario_map(const JsonDocument& document, const Pointer& at,
                              const fs::path& folder, const ReadOptions& options) {
    return MapReader(document, at, folder, options).read();
}

}  // namespace asv::io
