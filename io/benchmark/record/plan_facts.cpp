#include "io/benchmark/record/plan_facts.hpp"

#include <map>
#include <utility>

#include "io/text/number_text.hpp"

namespace asv::io {

namespace {

/// What is told of a plan, and in which words, in the order in which it is told.
using Facts = std::vector<std::pair<std::string, std::string>>;

std::string seconds_text(double seconds) {
    std::string text;
    append_number(text, seconds);
    return text + " s";
}

Facts limits(const BenchmarkReport& report) {
    const core::BenchmarkPlan& plan = report.plan;
    return {{"version", report.session.version},
            {"time limit", seconds_text(plan.time_limit)},
            {"optimize", seconds_text(plan.optimize)},
            {"threads", std::to_string(plan.threads)},
            {"memory limit",
             plan.memory_limit == 0 ? "none" : std::to_string(plan.memory_limit) + " MB"}};
}

void list(Facts& facts, const std::string& name, const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text.append(text.empty() ? "" : ", ").append(word);
    facts.emplace_back(name, text);
}

Facts all(const BenchmarkReport& report) {
    const core::BenchmarkPlan& plan = report.plan;
    Facts facts = limits(report);
    facts.emplace_back("jobs", std::to_string(plan.jobs));
    facts.emplace_back("seeds", seed_range(plan));
    std::vector<std::string> directions, problems, planners;
    for (const core::Direction direction : plan.directions)
        directions.emplace_back(core::name(direction));
    for (const core::BenchmarkProblem& problem : plan.problems) problems.push_back(problem.name);
    for (const core::BenchmarkPlanner& planner : plan.planners) planners.push_back(planner.label);
    list(facts, "directions", directions);
    list(facts, "problems", problems);
    list(facts, "planners", planners);
    for (const core::BenchmarkProblem& problem : plan.problems)
        facts.emplace_back("content of problem " + problem.name, problem.digest);
    for (const core::BenchmarkPlanner& planner : plan.planners)
        facts.emplace_back("planner " + planner.label, planner_text(planner));
    return facts;
}

/// What both tell, and tell otherwise: a problem that only one of them has is in the list of names.
std::vector<std::string> differences(const Facts& here, const Facts& there) {
    const std::map<std::string, std::string> others(there.begin(), there.end());
    std::vector<std::string> result;
    for (const auto& [name, text] : here) {
        const auto other = others.find(name);
        if (other == others.end() || other->second == text) continue;
        result.push_back(name);
        result.back()
            .append(": ")
            .append(text)
            .append(" here, ")
            .append(other->second)
            .append(" there");
    }
    return result;
}

}  // namespace

std::vector<std::string> differing_limits(const BenchmarkReport& here,
                                          const BenchmarkReport& there) {
    return differences(limits(here), limits(there));
}

std::vector<std::string> differing_plans(const BenchmarkReport& here,
                                         const BenchmarkReport& there) {
    return differences(all(here), all(there));
}

std::string seed_range(const core::BenchmarkPlan& plan) {
    return std::to_string(plan.first_seed) + " to " +
           std::to_string(plan.first_seed + plan.seeds - 1);
}

}  // namespace asv::io
