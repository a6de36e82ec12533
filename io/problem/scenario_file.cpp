#include "io/problem/scenario_file.hpp"

#include <algorithm>
#include <vector>

#include "core/chain/arm_kinematics.hpp"
#include "io/problem/many_steps.hpp"
#include "io/problem/scenario_ends.hpp"
#include "io/problem/scenario_limits.hpp"
#include "io/problem/scenario_map.hpp"
#include "io/problem/scenario_values.hpp"
#include "io/problem/thin_walls.hpp"
#include "io/text/json/document.hpp"
#include "io/text/parse_error.hpp"
#include "io/text/scanner.hpp"

namespace asv::io {

namespace {

using core::Problem;
using geometry::Box;
using geometry::Point;
using Pointer = JsonDocument::Pointer;

constexpr int format_version = 1;

constexpr std::ptrdiff_t longest_unit = 16;  // characters

class ScenarioReader {
  public:
    ScenarioReader(std::string_view text, const std::string& name, std::filesystem::path folder,
                   const ReadOptions& options)
        : document_(text, name),
          folder_(std::move(folder)),
          options_(options),
          goal_(root_ / (options.start_only ? "start" : "goal")) {}

    ProblemFile read() {
        require_members();
        document_.integer(root_ / "version", format_version, format_version);
        const std::string unit = read_unit();
        core::Requirements& required = problem_.requirements;
        const double size = size_of_brooms();
        required.tolerance = number_or("tolerance", size * required.tolerance, 0);
        required.max_step = number_or("step", size * required.max_step, min_positive);
        read_bounds();
        read_obstacles();
        if (document_.has(root_ / "map")) read_map_of_cells();
        read_body();
        if (document_.has(root_ / "limits"))
            problem_.motion_limits =
                read_motion_limits(document_, root_ / "limits", problem_.asv_count());
        // In the classic format nothing is far enough away.
        if (const auto why = why_so_many_steps(problem_)) warn(goal_, *why);
        return {
            std::move(problem_),         warnings_.take(), document_.place(root_ / "start").line,
            document_.place(goal_).line, std::move(maps_), unit};
    }

  private:
    void require_members() const {
        const std::initializer_list<std::string_view> optional{
            "unit", "bounds", "obstacles", "map", "step", "tolerance", "limits"};
        if (options_.start_only)
            document_.require_members(root_, {"version", "body", "start"}, optional);
        else
            document_.require_members(root_, {"version", "body", "start", "goal"}, optional);
    }

    double number_or(const char* key, double otherwise, double low) const {
        const Pointer at = root_ / key;
        return document_.has(at) ? document_.number(at, low, largest_number) : otherwise;
    }

    /// Free text: nothing is converted.
    std::string read_unit() const {
        const Pointer at = root_ / "unit";
        if (!document_.has(at)) return {};
        const std::string unit = document_.text(at);
        const auto begins_character = [](char c) {
            return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
        };
        const auto is_control = [](char c) { return static_cast<unsigned char>(c) < ' '; };
        const auto length = std::count_if(unit.begin(), unit.end(), begins_character);
        if (length < 1 || length > longest_unit ||
            std::any_of(unit.begin(), unit.end(), is_control))
            document_.fail(at, "the name of a unit, 1 to " + std::to_string(longest_unit) +
                                   " characters without line ends");
        return unit;
    }

    /// Of a chain's brooms, as a multiple of those of the public assignment; 1 for other bodies.
    /// What is wrong with the body is told where it is read.
    double size_of_brooms() const {
        const Pointer at = root_ / "body" / "broom_length";
        return document_.is_number(at) ? document_.number(at) / core::Requirements{}.broom_length
                                       : 1;
    }

    Box read_box(const Pointer& at) const {
        const std::string box = "a rectangle [[x, y], [x, y]], its lower left corner first";
        if (array_size(document_, at, box) != 2) document_.fail(at, box);
        const Box result{read_point(document_, at / 0), read_point(document_, at / 1)};
        if (geometry::is_empty(result)) document_.fail(at, box);
        return result;
    }

    void read_bounds() {
        const Pointer at = root_ / "bounds";
        if (!document_.has(at)) return;
        Box& bounds = problem_.requirements.bounds;
        bounds = document_.is_null(at) ? core::without_bounds() : read_box(at);
        if (!(bounds.low.x < bounds.high.x && bounds.low.y < bounds.high.y))
            document_.fail(at, "a rectangle with an area, or null");
    }

    double tolerance() const {
        return options_.tolerance.value_or(problem_.requirements.tolerance);
    }

    void read_obstacles() {
        const Pointer at = root_ / "obstacles";
        if (!document_.has(at)) return;
        const std::size_t count = array_size(document_, at, "an array of rectangles");
        if (count > max_obstacles)
            document_.fail(at, "at most " + std::to_string(max_obstacles) + " rectangles");
        problem_.obstacles.reserve(count);
        for (std::size_t i = 0; i < count; ++i) {
            problem_.obstacles.push_back(read_box(at / i));
            if (const auto why = why_it_vanishes(problem_.obstacles.back(), tolerance()))
                warn(at / i, "the rectangle " + *why);
        }
    }

    /// Where the scenario sets no bounds, those of the map hold.
    void read_map_of_cells() {
        const Pointer at = root_ / "map";
        ScenarioMap map = read_scenario_map(document_, at, folder_, options_);
        std::vector<Box>& obstacles = problem_.obstacles;
        if (obstacles.size() + map.obstacles.size() > max_obstacles)
            document_.fail(at, "at most " + std::to_string(max_obstacles) + " obstacles in all");
        const auto vanishes = [&](const Box& box) { return why_it_vanishes(box, tolerance()); };
        const auto thin = std::find_if(map.obstacles.begin(), map.obstacles.end(), vanishes);
        if (thin != map.obstacles.end()) warn(at, "a rectangle of cells " + *vanishes(*thin));
        obstacles.insert(obstacles.end(), map.obstacles.begin(), map.obstacles.end());
        maps_.insert(maps_.end(), map.files.begin(), map.files.end());
        for (Warning& warning : map.warnings) warnings_.add(std::move(warning));
        if (!document_.has(root_ / "bounds")) problem_.requirements.bounds = map.bounds;
    }

    void warn(const Pointer& at, const std::string& message) {
        // To find a place takes a walk through the text.
        if (warnings_.is_full()) return warnings_.add({});
        warnings_.add(document_.warning(at, message));
    }

    void read_body() {
        const Pointer at = root_ / "body";
        document_.require_object(at);
        const std::string kind = document_.has(at / "kind") ? document_.text(at / "kind") : "";
        if (kind == "chain") {
            read_chain(at);
        } else if (kind == "arm") {
            read_arm(at);
        } else if (kind == "point") {
            document_.require_members(at, {"kind"}, {});
            problem_.body = core::PointBody{};
            problem_.start = {read_point(document_, root_ / "start")};
            problem_.goal = {read_point(document_, goal_)};
        } else {
            document_.fail(at / "kind", "\"chain\", \"arm\" or \"point\"");
        }
    }

    void read_chain(const Pointer& at) {
        document_.require_members(at, {"kind"},
                                  {"asv_count", "broom_length", "minimum_area_factor"});
        core::Requirements& required = problem_.requirements;
        if (document_.has(at / "broom_length"))
            required.broom_length =
                document_.number(at / "broom_length", min_positive, largest_number);
        if (document_.has(at / "minimum_area_factor"))
            required.area_radius_per_broom =
                document_.number(at / "minimum_area_factor", 0, largest_number);
        read_chain_ends(at);
    }

    /// How many ASVs there are, body.asv_count says, or an end that lists their places or turns.
    void read_chain_ends(const Pointer& body) {
        const core::Requirements& required = problem_.requirements;
        const auto read = [&](const Pointer& end, std::size_t wanted) {
            return read_chain_end(document_, end, wanted, required);
        };
        const Pointer count = body / "asv_count";
        std::size_t wanted = 0;
        if (document_.has(count)) {
            wanted = static_cast<std::size_t>(
                document_.integer(count, 1, static_cast<std::int64_t>(max_asvs)));
        } else if (is_shape(document_, root_ / "start")) {
            if (is_shape(document_, goal_))
                document_.fail(count, "the number of ASVs, which shapes do not tell,");
            wanted = read(goal_, 0).size();
        }
        problem_.start = read(root_ / "start", wanted);
        problem_.goal = read(goal_, problem_.start.size());
    }

    void read_arm(const Pointer& at) {
        document_.require_members(at, {"kind", "base", "links", "angles", "joints"}, {});
        core::PlanarArm arm;
        const Point base = read_point(document_, at / "base");
        const std::size_t count = array_size(document_, at / "links", "an array of link lengths");
        if (count == 0) document_.fail(at / "links", "at least one link length");
        if (count > max_asvs)
            document_.fail(at / "links", "at most " + std::to_string(max_asvs) + " links");
        for (std::size_t i = 0; i < count; ++i)
            arm.links.push_back(document_.number(at / "links" / i, min_positive, largest_number));
        const std::string angles = document_.text(at / "angles");
        if (angles != "relative" && angles != "absolute")
            document_.fail(at / "angles", "\"relative\" or \"absolute\"");
        arm.angles = angles == "relative" ? core::AngleReference::previous_link
                                          : core::AngleReference::x_axis;
        arm.joints = read_joints(at / "joints", count);
        arm.start = read_arm_end(document_, root_ / "start", arm);
        arm.goal = read_arm_end(document_, goal_, arm);
        problem_.start = core::arm_points(arm, base, arm.start);
        problem_.goal = core::arm_points(arm, base, arm.goal);
        problem_.body = std::move(arm);
        if (problem_.requirements.max_step > largest_step(problem_))
            document_.fail(root_ / "step", "at most the length of the shortest link");
    }

    /// "wrap" or [low, high] for all joints, or an array with one of these for each.
    std::vector<core::JointRange> read_joints(const Pointer& at, std::size_t count) const {
        const bool for_all =
            !document_.is_array(at) || (document_.has(at / 0) && document_.is_number(at / 0));
        if (for_all) return std::vector<core::JointRange>(count, read_joint(at));
        if (document_.array(at).size() != count)
            document_.fail(at, "\"wrap\", [low, high], or one of these for each of " +
                                   std::to_string(count) + " links");
        std::vector<core::JointRange> joints;
        for (std::size_t i = 0; i < count; ++i) joints.push_back(read_joint(at / i));
        return joints;
    }

    core::JointRange read_joint(const Pointer& at) const {
        const std::string what = "\"wrap\" or angles [low, high] in radians";
        if (document_.is_text(at) && document_.text(at) == "wrap") return {.wraps = true};
        if (!document_.is_array(at) || document_.array(at).size() != 2) document_.fail(at, what);
        const auto angle = [&](const Pointer& place) {
            return document_.number(place, -largest_angle, largest_angle);
        };
        core::JointRange range{false, angle(at / 0), angle(at / 1)};
        if (range.low > range.high) document_.fail(at, what);
        return range;
    }

    const Pointer root_;
    JsonDocument document_;
    std::filesystem::path folder_;
    ReadOptions options_;
    const Pointer goal_;  ///< where it is told
    Problem problem_;
    WarningList warnings_;
    std::vector<std::filesystem::path> maps_;
};

}  // namespace

bool is_scenario(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && text[first] == '{';
}

ProblemFile parse_scenario(std::string_view text, const std::string& name,
                           const std::filesystem::path& folder, const ReadOptions& options) {
    return ScenarioReader(text, name, folder, options).read();
}

}  // namespace asv::io
