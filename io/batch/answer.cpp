#include "io/batch/answer.hpp"

#include <nlohmann/json.hpp>

namespace asv::io {

namespace {

using nlohmann::ordered_json;

ordered_json begun_answer(const Query& query, std::string_view status) {
    ordered_json answer = {{"line", query.line}};
    if (!query.id.empty()) answer["id"] = ordered_json::parse(query.id);
    answer["status"] = status;
    return answer;
}

ordered_json end_of_query(const core::Placement& placement, core::BodyKind kind) {
    if (kind == core::BodyKind::arm) return placement.angles;
    ordered_json points = ordered_json::array();
    for (const geometry::Point& point : placement.points) points.push_back({point.x, point.y});
    return kind == core::BodyKind::point ? points.at(0) : points;
}

std::string as_line(const ordered_json& answer) {
    // The name of a file, which an error may tell, need not be UTF-8.
    return answer.dump(-1, ' ', false, ordered_json::error_handler_t::replace) + '\n';
}

}  // namespace

std::string answer_text(const Query& query, const core::SolveResult& result, core::BodyKind kind) {
    ordered_json answer = begun_answer(query, core::name(result.status));
    if (result.solution) {
        answer["cost"] = result.statistics.cost;
        answer["primitive_steps"] = result.solution->path.size() - 1;
        ordered_json& corners = answer["corners"] = ordered_json::array();
        for (const core::Placement& corner : result.corners)
            corners.push_back(end_of_query(corner, kind));
    } else {
        answer["reason"] = result.reason;
    }
    return as_line(answer);
}

std::string refusal_text(const Query& query, const std::string& error) {
    ordered_json answer = begun_answer(query, "error");
    answer["reason"] = error;
    return as_line(answer);
}

}  // namespace asv::io
