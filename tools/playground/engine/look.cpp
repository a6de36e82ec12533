// What there is to say of a problem and of a path without planning: check, validate, profile.

#include <limits>

#include "core/bounds/feasibility.hpp"
#include "core/model/cost.hpp"
#include "core/validation/validate.hpp"
#include "io/drawing/path_profile.hpp"
#include "tools/playground/engine/answer.hpp"

namespace asv::playground {

namespace {

Json number_from_one(const std::optional<std::size_t>& index) {
    return index ? Json(*index + 1) : Json(nullptr);
}

/// What an end violates.
Json violations(const core::Problem& problem, const std::vector<core::Point>& end) {
    const core::ValidationReport report =
        core::validate_state(problem, end, {.tolerance = problem.requirements.tolerance});
    Json found = Json::array();
    for (const core::CheckResult& check : report.checks) {
        if (check.ok()) continue;
        found.push_back({{"requirement", core::name(check.check)},
                         {"text", core::describe(check)},
                         {"asv", number_from_one(check.worst->asv)},
                         {"broom", number_from_one(check.worst->broom)},
                         {"obstacle", number_from_one(check.worst->obstacle)}});
    }
    return found;
}

Json infeasibility(const core::Problem& problem, bool valid_ends) {
    const core::Feasibility proof =
        valid_ends ? core::check_feasibility(problem) : core::check_area(problem);
    return proof.cause == core::Infeasibility::none ? Json(nullptr) : Json(proof.reason);
}

void add_checks(const std::vector<core::CheckResult>& checks, const char* suffix, Json& list) {
    for (const core::CheckResult& check : checks)
        list.push_back({{"name", std::string(core::name(check.check)) + suffix},
                        {"ok", check.ok()},
                        {"text", core::describe(check)}});
}

}  // namespace

Answer check(const Request& request) {
    const core::Problem problem = problem_of(request);
    Answer answer;
    answer.json["start"] = violations(problem, problem.start);
    answer.json["goal"] = violations(problem, problem.goal);
    const bool chain = problem.body_kind() == core::BodyKind::chain;
    answer.json["minimumArea"] = chain ? problem.requirements.min_area(problem.asv_count()) : 0.0;
    const bool valid_ends = answer.json["start"].empty() && answer.json["goal"].empty();
    answer.json["infeasible"] = infeasibility(problem, valid_ends);
    return answer;
}

Answer validate(const Request& request) {
    const core::Problem problem = problem_of(request);
    core::Solution solution{path_of(request.states, problem.asv_count()), 0};
    solution.cost = core::cost(problem, solution.path);
    const core::ValidationReport report = core::validate(
        problem, solution, {.tolerance = problem.requirements.tolerance, .continuous = true});
    Answer answer;
    answer.json = {{"valid", report.valid()}, {"checks", Json::array()}, {"cost", report.cost}};
    add_checks(report.checks, "", answer.json["checks"]);
    add_checks(report.motion, " in motion", answer.json["checks"]);
    return answer;
}

Answer profile(const Request& request) {
    const core::Problem problem = problem_of(request);
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> clearance, area, turn, cost;
    for (const io::StateMeasures& state :
         io::measure(problem, path_of(request.states, problem.asv_count()))) {
        clearance.push_back(state.clearance ? state.clearance->distance : nothing);
        area.push_back(state.area);
        turn.push_back(state.tightest_turn.value_or(nothing));
        cost.push_back(state.cost);
    }
    Answer answer;
    answer.add("clearance", std::move(clearance));
    answer.add("area", std::move(area));
    answer.add("turn", std::move(turn));
    answer.add("cost", std::move(cost));
    return answer;
}

}  // namespace asv::playground
