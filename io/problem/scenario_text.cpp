#include "io/problem/scenario_text.hpp"

#include <vector>

#include <nlohmann/json.hpp>

namespace asv::io {

namespace {

using core::Point;
using nlohmann::ordered_json;

constexpr int scenario_version = 1;

ordered_json to_json(const Point& point) {
    return {point.x, point.y};
}

ordered_json to_json(const core::Box& box) {
    return {to_json(box.low), to_json(box.high)};
}

ordered_json to_json(const core::JointRange& range) {
    return range.wraps ? ordered_json("wrap") : ordered_json{range.low, range.high};
}

template <class Element>
ordered_json array_of(const std::vector<Element>& elements) {
    ordered_json array = ordered_json::array();
    for (const Element& element : elements) array.push_back(to_json(element));
    return array;
}

ordered_json body_of(const core::Problem& problem) {
    switch (problem.body_kind()) {
        case core::BodyKind::point:
            return {{"kind", "point"}};
        case core::BodyKind::chain:
            return {{"kind", "chain"},
                    {"broom_length", problem.requirements.broom_length},
                    {"minimum_area_factor", problem.requirements.area_radius_per_broom}};
        case core::BodyKind::arm:
            break;
    }
    const core::PlanarArm& arm = *problem.arm();
    const bool relative = arm.angles == core::AngleReference::previous_link;
    return {{"kind", "arm"},
            {"base", to_json(problem.start.front())},
            {"links", arm.links},
            {"angles", relative ? "relative" : "absolute"},
            {"joints", array_of(arm.joints)}};
}

/// Where the body starts or ends: the points of a chain, the angles of an arm, a point.
ordered_json end_of(const core::Problem& problem, bool goal) {
    const std::vector<Point>& points = goal ? problem.goal : problem.start;
    if (const core::PlanarArm* arm = problem.arm()) return goal ? arm->goal : arm->start;
    if (problem.body_kind() == core::BodyKind::point) return to_json(points.front());
    return array_of(points);
}

ordered_json to_json(const core::MotionLimits& limits) {
    ordered_json json = ordered_json::object();
    if (!limits.speed.empty()) json["speed"] = limits.speed;
    if (!limits.acceleration.empty()) json["acceleration"] = limits.acceleration;
    // A list of one is a number for all.
    for (auto& list : json)
        if (list.size() == 1) list = ordered_json(list[0]);
    return json;
}

}  // namespace

ordered_json scenario_json(const core::Problem& problem) {
    const core::Requirements& required = problem.requirements;
    ordered_json json = {
        {"version", scenario_version},
        {"body", body_of(problem)},
        {"start", end_of(problem, false)},
        {"goal", end_of(problem, true)},
        {"bounds", required.bounded() ? to_json(required.bounds) : ordered_json(nullptr)},
        {"obstacles", array_of(problem.obstacles)},
        {"step", required.max_step},
        {"tolerance", required.tolerance}};
    if (problem.motion_limits != core::MotionLimits{})
        json["limits"] = to_json(problem.motion_limits);
    return json;
}

std::string format_scenario(const core::Problem& problem, const std::string& unit) {
    std::string text;
    ordered_json json = scenario_json(problem);
    if (!unit.empty()) json["unit"] = unit;
    for (const auto& [member, value] : json.items())
        text += (text.empty() ? "{" : ",\n ") + ordered_json(member).dump() + ": " + value.dump();
    return text + "}\n";
}

}  // namespace asv::io
