#include "io/problem/scenario_ends.hpp"

#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>

#include "core/shapes/chain_shapes.hpp"
#include "io/problem/reading.hpp"
#include "io/problem/scenario_values.hpp"
#include "io/text/number_text.hpp"
#include "io/text/scanner.hpp"

namespace asv::io {

namespace {

using geometry::Point;
using Pointer = JsonDocument::Pointer;

constexpr double half_turn = 180;    // degrees
constexpr double whole_turn = 360;   // degrees
constexpr double most_turns = 3600;  // degrees; more is a slip, and far turns are less exact

double radians(double degrees) {
    return degrees * std::numbers::pi / half_turn;
}

std::string degrees_text(double radians) {
    std::string text;
    append_number(text, radians * half_turn / std::numbers::pi);
    return text;
}

/// An angle in degrees, in radians.
double read_heading(const JsonDocument& document, const Pointer& at) {
    return radians(document.number(at, -most_turns, most_turns));
}

std::vector<Point> read_points(const JsonDocument& document, const Pointer& at,
                               std::size_t wanted) {
    const std::string what = wanted == 0 ? "an array of points [x, y], one for each ASV"
                                         : "an array of " + std::to_string(wanted) + " points";
    const std::size_t count = array_size(document, at, what);
    if (count > max_asvs) document.fail(at, "at most " + std::to_string(max_asvs) + " points");
    if (count == 0 || (wanted != 0 && count != wanted)) document.fail(at, what);
    std::vector<Point> points;
    for (std::size_t i = 0; i < count; ++i) points.push_back(read_point(document, at / i));
    return points;
}

std::vector<Point> read_turns(const JsonDocument& document, const Pointer& at, std::size_t wanted,
                              double broom_length) {
    document.require_members(at, {"at", "heading", "turns"}, {});
    // ASV 1 and ASV n have no turn.
    if (wanted == 1) document.fail(at, "an array of 1 points");
    const std::string what =
        wanted == 0 ? "an array of turns in degrees, one for each ASV but the first and the last"
                    : "an array of " + std::to_string(wanted - 2) + " turns in degrees";
    const std::size_t count = array_size(document, at / "turns", what);
    if (count > max_asvs - 2)
        document.fail(at / "turns", "at most " + std::to_string(max_asvs - 2) + " turns");
    if (wanted != 0 && count != wanted - 2) document.fail(at / "turns", what);
    std::vector<double> turns;
    for (std::size_t i = 0; i < count; ++i)
        turns.push_back(radians(document.number(at / "turns" / i, -half_turn, half_turn)));
    return core::chain_positions(turns, read_heading(document, at / "heading"),
                                 read_point(document, at / "at"), broom_length);
}

bool read_clockwise(const JsonDocument& document, const Pointer& at) {
    if (!document.has(at)) return false;
    const std::string orientation = document.text(at);
    if (orientation != "clockwise" && orientation != "counter-clockwise")
        document.fail(at, "\"counter-clockwise\" or \"clockwise\"");
    return orientation == "clockwise";
}

double read_bend(const JsonDocument& document, const Pointer& at) {
    if (!document.has(at)) return core::usual_bend;
    const double bend = document.number(at, 0, whole_turn);
    if (bend == 0 || bend == whole_turn)
        document.fail(at, "a number between 0 and 360, neither included");
    return radians(bend);
}

std::optional<std::size_t> read_leg(const JsonDocument& document, const Pointer& at,
                                    std::size_t asv_count) {
    if (!document.has(at)) return std::nullopt;
    if (asv_count < 3) document.fail(at, "no leg where there are fewer than 3 ASVs");
    // At least one of the asv_count - 1 brooms is left to bend.
    return static_cast<std::size_t>(
        document.integer(at, 1, static_cast<std::int64_t>(asv_count) - 2));
}

std::vector<Point> read_shape(const JsonDocument& document, const Pointer& at,
                              std::size_t asv_count, const core::Requirements& requirements) {
    const std::string shape = document.text(at / "shape");
    if (shape == "line") {
        document.require_members(at, {"shape", "at", "heading"}, {"orientation"});
    } else if (shape == "arc") {
        document.require_members(at, {"shape", "at", "heading"}, {"orientation", "bend"});
    } else if (shape == "hook") {
        document.require_members(at, {"shape", "at", "heading"}, {"orientation", "bend", "leg"});
    } else {
        document.fail(at / "shape", "\"line\", \"arc\" or \"hook\"");
    }
    const core::ShapePlace place{read_point(document, at / "at"),
                                 read_heading(document, at / "heading"),
                                 read_clockwise(document, at / "orientation")};
    const double bend = read_bend(document, at / "bend");
    const auto leg = read_leg(document, at / "leg", asv_count);
    try {
        if (shape == "line") return core::line_chain(asv_count, requirements, place);
        if (shape == "arc") return core::arc_chain(asv_count, requirements, place, bend);
        return core::hook_chain(asv_count, requirements, place, bend, leg);
    } catch (const std::invalid_argument& error) {
        document.fail(at, "a shape of " + std::to_string(asv_count) +
                              " ASVs that meets the requirements (" + error.what() + ")");
    }
}

/// A heading and turns in degrees, as the angles of the arm are told. Their ranges are not looked
/// at.
std::vector<double> read_arm_turns(const JsonDocument& document, const Pointer& at,
                                   const core::PlanarArm& arm) {
    document.require_members(at, {"heading", "turns"}, {});
    const std::size_t count = arm.links.size() - 1;
    const std::string what = "an array of " + std::to_string(count) + " turns in degrees";
    if (array_size(document, at / "turns", what) != count) document.fail(at / "turns", what);
    std::vector<double> angles{read_heading(document, at / "heading")};
    const bool relative = arm.angles == core::AngleReference::previous_link;
    for (std::size_t i = 0; i < count; ++i) {
        const double turn = read_heading(document, at / "turns" / i);
        angles.push_back(relative ? turn : angles.back() + turn);
    }
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const core::JointRange& range = arm.joints[i];
        if (range.wraps || (angles[i] >= range.low && angles[i] <= range.high)) continue;
        document.fail(i == 0 ? at / "heading" : at / "turns" / (i - 1),
                      "an angle of joint " + std::to_string(i + 1) + " from " +
                          degrees_text(range.low) + " to " + degrees_text(range.high) + " degrees");
    }
    return angles;
}

std::vector<double> read_angles(const JsonDocument& document, const Pointer& at,
                                const core::PlanarArm& arm) {
    const std::string what =
        "an array of " + std::to_string(arm.links.size()) + " joint angles in radians";
    if (array_size(document, at, what) != arm.links.size()) document.fail(at, what);
    std::vector<double> angles;
    for (std::size_t i = 0; i < arm.links.size(); ++i) {
        const core::JointRange& range = arm.joints[i];
        const double low = range.wraps ? -largest_angle : range.low;
        const double high = range.wraps ? largest_angle : range.high;
        angles.push_back(document.number(at / i, low, high));
    }
    return angles;
}

}  // namespace

bool is_shape(const JsonDocument& document, const Pointer& at) {
    return document.has(at / "shape");
}

std::vector<Point> read_chain_end(const JsonDocument& document, const Pointer& at,
                                  std::size_t wanted, const core::Requirements& requirements) {
    if (is_shape(document, at)) return read_shape(document, at, wanted, requirements);
    if (document.is_object(at)) return read_turns(document, at, wanted, requirements.broom_length);
    return read_points(document, at, wanted);
}

std::vector<double> read_arm_end(const JsonDocument& document, const Pointer& at,
                                 const core::PlanarArm& arm) {
    return document.is_object(at) ? read_arm_turns(document, at, arm)
                                  : read_angles(document, at, arm);
}

}  // namespace asv::io
