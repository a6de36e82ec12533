#include "io/problem/scenario_text.hpp"

#include <vector>

#include <nlohmann/json.hpp>

namespace asv::io {

namespace {

using nlohmann::ordered_json;

ordered_json point_json(const core::Point& point) {
    return {point.x, point.y};
}

ordered_json points_json(const std::vector<core::Point>& points) {
    ordered_json list = ordered_json::array();
    for (const core::Point& point : points) list.push_back(point_json(point));
    return list;
}

ordered_json box_json(const core::Box& box) {
    return {point_json(box.low), point_json(box.high)};
}

ordered_json joints_json(const core::PlanarArm& arm) {
    ordered_json list = ordered_json::array();
    for (const core::JointRange& range : arm.joints) {
        if (range.wraps)
            list.push_back("wrap");
        else
            list.push_back({range.low, range.high});
    }
    return list;
}

/// Members "body", "start" and "goal".
void put_body(ordered_json& scenario, const core::Problem& problem) {
    switch (problem.body_kind()) {
        case core::BodyKind::chain:
            scenario["body"] = {
                {"kind", "chain"},
                {"broom_length", problem.requirements.broom_length},
                {"minimum_area_factor", problem.requirements.area_radius_per_broom}};
            scenario["start"] = points_json(problem.start);
            scenario["goal"] = points_json(problem.goal);
            return;
        case core::BodyKind::arm: {
            const core::PlanarArm& arm = *problem.arm();
            const bool relative = arm.angles == core::AngleReference::previous_link;
            scenario["body"] = {{"kind", "arm"},
                                {"base", point_json(problem.start.front())},
                                {"links", arm.links},
                                {"angles", relative ? "relative" : "absolute"},
                                {"joints", joints_json(arm)}};
            scenario["start"] = arm.start;
            scenario["goal"] = arm.goal;
            return;
        }
        case core::BodyKind::point:
            scenario["body"] = {{"kind", "point"}};
            scenario["start"] = point_json(problem.start.front());
            scenario["goal"] = point_json(problem.goal.front());
            return;
    }
}

}  // namespace

std::string format_scenario(const core::Problem& problem) {
    const core::Requirements& required = problem.requirements;
    ordered_json scenario = {{"version", 1}};
    put_body(scenario, problem);
    scenario["bounds"] = required.bounded() ? box_json(required.bounds) : ordered_json(nullptr);
    scenario["step"] = required.max_step;
    scenario["tolerance"] = required.tolerance;
    ordered_json& obstacles = scenario["obstacles"] = ordered_json::array();
    for (const core::Box& box : problem.obstacles) obstacles.push_back(box_json(box));
    return scenario.dump() + "\n";
}

}  // namespace asv::io
