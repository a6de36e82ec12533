#include "io/benchmark/wording.hpp"

#include <algorithm>

#include "io/text/number_text.hpp"

namespace asv::io {

namespace {

std::string seeds_text(const core::BenchmarkPlan& plan) {
    const std::string first = std::to_string(plan.first_seed);
    if (plan.seeds == 1) return "Seed " + first;
    return "Seeds " + first + " to " + std::to_string(plan.first_seed + plan.seeds - 1);
}

/// The digits that were given.
std::string seconds_text(double seconds) {
    std::string text;
    append_number(text, seconds);
    return text + " s";
}

}  // namespace

std::string plural(std::size_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string problem_facts(const core::Problem& problem, double lower_bound) {
    std::string text;
    switch (problem.body_kind()) {
        case core::BodyKind::chain:
            text = plural(problem.asv_count(), "ASV");
            break;
        case core::BodyKind::arm:
            text = "arm with " + plural(problem.asv_count() - 1, "joint");
            break;
        case core::BodyKind::point:
            text = "point";
            break;
    }
    text += ", " + plural(problem.obstacles.size(), "obstacle");
    if (lower_bound > 0) text += "; no path costs less than " + short_number(lower_bound);
    return text;
}

std::string plan_facts(const core::BenchmarkPlan& plan) {
    return seeds_text(plan) + ", time limit " + seconds_text(plan.time_limit) + ", optimize " +
           seconds_text(plan.optimize) + ", " + plural(plan.threads, "thread") +
           (plan.memory_limit == 0 ? std::string()
                                   : ", memory limit " + std::to_string(plan.memory_limit) + " MB");
}

std::string sessions_note(const BenchmarkSession& session) {
    const auto& parts = session.parts;
    if (parts.empty()) return {};
    const bool several_machines = std::any_of(parts.begin(), parts.end(), [&](const auto& part) {
        return part.host != parts[0].host || part.cpu != parts[0].cpu;
    });
    return " Runs of " + plural(parts.size(), "session") +
           (several_machines ? " on several machines: their times do not compare." : ".");
}

std::string spoilt_note(const core::BenchmarkPlan& plan) {
    if (plan.jobs == 1) return {};
    return plural(plan.jobs, "run") + " side by side: their times are spoilt.";
}

}  // namespace asv::io
