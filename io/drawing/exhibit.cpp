#include "io/drawing/exhibit.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "io/text/valid_text.hpp"

namespace asv::io {

namespace {

using core::CheckResult;

core::ValidationReport judge(const ExhibitInput& input) {
    const core::Problem& problem = input.problem;
    const double tolerance = problem.requirements.tolerance;
    if (input.solution) {
        return core::validate(problem, *input.solution,
                              {.tolerance = tolerance, .list_offenders = true});
    }
    core::ValidationReport both =
        core::validate_state(problem, problem.start, {.tolerance = tolerance});
    const core::ValidationReport goal =
        core::validate_state(problem, problem.goal, {.tolerance = tolerance});
    for (CheckResult result : goal.checks) {
        if (result.worst) result.worst->state = 1;
        both.checks.push_back(result);
    }
    return both;
}

std::vector<Violation> by_state(const core::ValidationReport& report) {
    std::vector<Violation> result;
    for (const CheckResult& check : report.checks) {
        for (const core::Offender& offender : check.offenders) {
            result.push_back({check.check, offender});
        }
    }
    std::stable_sort(result.begin(), result.end(), [](const Violation& a, const Violation& b) {
        return a.offender.state < b.offender.state;
    });
    return result;
}

std::optional<std::size_t> find_tightest(const std::vector<StateMeasures>& measures) {
    const auto least = std::min_element(
        measures.begin(), measures.end(), [](const StateMeasures& a, const StateMeasures& b) {
            return a.clearance && b.clearance && a.clearance->distance < b.clearance->distance;
        });
    if (least == measures.end() || !least->clearance) return std::nullopt;
    return static_cast<std::size_t>(least - measures.begin());
}

/// Why there is no path, where that is known in little time and memory.
core::Feasibility feasibility_of(const ExhibitInput& input, bool valid_ends) {
    constexpr std::size_t most_obstacles = 20'000;
    if (input.solution || !valid_ends || input.problem.obstacles.size() > most_obstacles) return {};
    const core::Feasibility found = core::check_feasibility(input.problem);
    return found.cause != core::Infeasibility::none ? found : core::check_passages(input.problem);
}

std::string counted(std::size_t count, const std::string& what) {
    return grouped(count) + " " + what + (count == 1 ? "" : "s");
}

std::string body_of(const core::Problem& problem) {
    if (problem.arm()) return "arm of " + counted(problem.arm()->links.size(), "link");
    if (problem.body_kind() == core::BodyKind::point) return "point";
    return counted(problem.asv_count(), "ASV");
}

}  // namespace

Exhibit make_exhibit(ExhibitInput input) {
    Exhibit exhibit;
    exhibit.report = judge(input);
    exhibit.feasibility = feasibility_of(input, exhibit.report.valid());
    if (input.solution) {
        exhibit.measures = measure(input.problem, input.solution->path);
        exhibit.violations = by_state(exhibit.report);
        exhibit.tightest_state = find_tightest(exhibit.measures);
    }
    static_cast<ExhibitInput&>(exhibit) = std::move(input);
    exhibit.name = valid_text(exhibit.name);
    exhibit.planner = valid_text(exhibit.planner);
    return exhibit;
}

BodyWords words_for(core::BodyKind body) {
    switch (body) {
        case core::BodyKind::chain:
            return {"ASV 1 has an eye", "chain", "path of an ASV", "broom", "ASV 1",
                    "path of ASV 1",    "ASV"};
        case core::BodyKind::arm:
            return {"the base has an eye", "arm",  "path of a joint or the tip", "link", "tip",
                    "path of the tip",     "joint"};
        case core::BodyKind::point:
            break;
    }
    return {"", "point", "path of the point", "", "point", "path of the point", ""};
}

std::string grouped(std::size_t number) {
    std::string digits = std::to_string(number);
    for (std::size_t end = digits.size(); end > 3; end -= 3) digits.insert(end - 3, 1, ',');
    return digits;
}

std::string with_unit(std::string length, const std::string& unit) {
    return unit.empty() ? length : std::move(length) + " " + unit;
}

std::string fixed(double number, int digits) {
    std::array<char, 400> text{};
    const int length = std::snprintf(text.data(), text.size(), "%.*f", digits, number);
    return {text.data(), static_cast<std::size_t>(length)};
}

std::string facts(const Exhibit& exhibit) {
    const std::string dot = " · ";
    std::string text =
        body_of(exhibit.problem) + dot + counted(exhibit.problem.obstacles.size(), "obstacle");
    const std::string unit = exhibit.problem.arm() ? "" : exhibit.unit;
    if (exhibit.solution) text += dot + "cost " + with_unit(fixed(exhibit.solution->cost, 4), unit);
    if (exhibit.lower_bound) {
        text += dot + "lower bound " + with_unit(fixed(*exhibit.lower_bound, 4), unit);
        // What is not a path cannot be near the best one.
        if (exhibit.solution && exhibit.report.valid() && *exhibit.lower_bound > 0) {
            text += " (ratio " + fixed(exhibit.solution->cost / *exhibit.lower_bound, 3) + ")";
        }
    }
    if (exhibit.solution) text += dot + counted(exhibit.solution->path.size() - 1, "step");
    if (!exhibit.planner.empty()) text += dot + exhibit.planner;
    return text;
}

std::string verdict(const Exhibit& exhibit) {
    const auto failed = static_cast<std::size_t>(
        std::count_if(exhibit.report.checks.begin(), exhibit.report.checks.end(),
                      [](const CheckResult& result) { return !result.ok(); }));
    if (exhibit.feasibility.cause != core::Infeasibility::none) return "there is no path";
    if (!exhibit.solution)
        return failed == 0 ? "start and goal are valid" : "start or goal is not valid";
    if (failed == 0) return "valid";
    return "not valid: " + std::to_string(failed) + " of " +
           std::to_string(exhibit.report.checks.size()) + " requirements violated";
}

std::vector<std::string> complaints(const Exhibit& exhibit) {
    std::vector<std::string> result;
    for (const CheckResult& check : exhibit.report.checks) {
        if (check.ok()) continue;
        std::string text = std::string(core::name(check.check)) + ": " + core::describe(check);
        if (check.worst && check.check != core::Check::cost) {
            const std::size_t state = check.worst->state;
            text += exhibit.solution ? " (step " + grouped(state) + ")"
                                     : (state == 0 ? " (start)" : " (goal)");
        }
        result.push_back(std::move(text));
    }
    if (!exhibit.feasibility.reason.empty()) result.push_back(exhibit.feasibility.reason);
    return result;
}

}  // namespace asv::io
