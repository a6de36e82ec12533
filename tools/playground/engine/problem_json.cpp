#include "tools/playground/engine/problem_json.hpp"

#include "io/problem/scenario_file.hpp"

namespace asv::playground {

namespace {

using core::Point;

constexpr int scenario_version = 1;

Json to_json(const Point& point) {
    return {point.x, point.y};
}

Json to_json(const core::Box& box) {
    return {to_json(box.low), to_json(box.high)};
}

Json to_json(const core::JointRange& range) {
    return range.wraps ? Json("wrap") : Json{range.low, range.high};
}

template <class Element>
Json array_of(const std::vector<Element>& elements) {
    Json array = Json::array();
    for (const Element& element : elements) array.push_back(to_json(element));
    return array;
}

Json body_of(const core::Problem& problem) {
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
Json end_of(const core::Problem& problem, bool goal) {
    const std::vector<Point>& points = goal ? problem.goal : problem.start;
    if (const core::PlanarArm* arm = problem.arm()) return goal ? arm->goal : arm->start;
    if (problem.body_kind() == core::BodyKind::point) return to_json(points.front());
    return array_of(points);
}

}  // namespace

core::Problem problem_of(const Request& request) {
    const std::string text = request.json.at("problem").dump();
    return io::parse_scenario(text, "problem", "").problem;
}

Json to_json(const core::Problem& problem) {
    const core::Requirements& required = problem.requirements;
    return {{"version", scenario_version},
            {"body", body_of(problem)},
            {"start", end_of(problem, false)},
            {"goal", end_of(problem, true)},
            {"bounds", required.bounded() ? to_json(required.bounds) : Json(nullptr)},
            {"obstacles", array_of(problem.obstacles)},
            {"step", required.max_step},
            {"tolerance", required.tolerance}};
}

std::string format_scenario(const core::Problem& problem) {
    std::string text;
    const Json json = to_json(problem);
    for (const auto& [member, value] : json.items())
        text += (text.empty() ? "{" : ",\n ") + Json(member).dump() + ": " + value.dump();
    return text + "}\n";
}

}  // namespace asv::playground
