#include "io/benchmark/record/merge.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "io/benchmark/record/plan_facts.hpp"

namespace asv::io {

namespace {

using core::BenchmarkPlan;
using core::RunPlace;

std::string place_text(const BenchmarkPlan& plan, const RunPlace& place) {
    return plan.problems[place.problem].name + " " + std::string(core::name(place.direction)) +
           ", " + plan.planners[place.planner].label + ", seed " + std::to_string(place.seed);
}

/// Takes in one benchmark after the other.
class Merger {
  public:
    explicit Merger(NamedReport first) : whole_(std::move(first.report)), first_file_(first.file) {
        sessions_.push_back(whole_.session);
        for (const core::BenchmarkRun& run : whole_.runs)
            if (!owners_.emplace(run.place, first_file_).second)
                refuse_twice(first_file_, run.place);
    }

    void add(const NamedReport& next) {
        const auto differing = differing_limits(whole_, next.report);
        if (!differing.empty()) refuse(next, "another " + differing[0]);
        add_seeds(next);
        for (const core::Direction direction : next.report.plan.directions) add(direction);
        std::vector<std::size_t> problems, planners;
        for (const core::BenchmarkProblem& problem : next.report.plan.problems)
            problems.push_back(index_of(problem, next));
        for (const core::BenchmarkPlanner& planner : next.report.plan.planners)
            planners.push_back(index_of(planner, next));
        for (core::BenchmarkRun run : next.report.runs) {
            run.place.problem = problems[run.place.problem];
            run.place.planner = planners[run.place.planner];
            if (!owners_.emplace(run.place, next.file).second) refuse_twice(next.file, run.place);
            whole_.runs.push_back(std::move(run));
        }
        whole_.plan.jobs = std::max(whole_.plan.jobs, next.report.plan.jobs);
        sessions_.push_back(next.report.session);
    }

    BenchmarkReport end() {
        core::sort_as_told(whole_.runs);
        whole_.session = joined(std::move(sessions_));
        return std::move(whole_);
    }

  private:
    [[noreturn]] void refuse(const NamedReport& next, const std::string& why) const {
        throw MergeError(first_file_ + " and " + next.file + " do not belong together: " + why);
    }

    [[noreturn]] void refuse_twice(const std::string& file, const RunPlace& place) const {
        throw MergeError("the run " + place_text(whole_.plan, place) + " is in " +
                         owners_.at(place) + " and again in " + file);
    }

    void add_seeds(const NamedReport& next) {
        BenchmarkPlan& plan = whole_.plan;
        const BenchmarkPlan& other = next.report.plan;
        // Both behind their last seeds; no seed is so large that this could overflow.
        const std::uint64_t end = plan.first_seed + plan.seeds;
        const std::uint64_t other_end = other.first_seed + other.seeds;
        if (other.first_seed > end || plan.first_seed > other_end)
            refuse(next, "seeds " + seed_range(plan) + " and " + seed_range(other) +
                             " leave a gap between them");
        plan.first_seed = std::min(plan.first_seed, other.first_seed);
        plan.seeds = static_cast<std::size_t>(std::max(end, other_end) - plan.first_seed);
    }

    void add(core::Direction direction) {
        auto& all = whole_.plan.directions;
        if (std::find(all.begin(), all.end(), direction) == all.end()) all.push_back(direction);
        std::sort(all.begin(), all.end());
    }

    std::size_t index_of(const core::BenchmarkProblem& problem, const NamedReport& next) {
        auto& all = whole_.plan.problems;
        const auto known = std::find_if(all.begin(), all.end(), [&](const auto& candidate) {
            return candidate.name == problem.name;
        });
        const auto index = static_cast<std::size_t>(known - all.begin());
        if (known == all.end())
            all.push_back(problem);
        else if (known->digest != problem.digest)
            refuse(next, "another content of problem " + problem.name);
        return index;
    }

    std::size_t index_of(const core::BenchmarkPlanner& planner, const NamedReport& next) {
        auto& all = whole_.plan.planners;
        const auto known = std::find_if(all.begin(), all.end(), [&](const auto& candidate) {
            return candidate.label == planner.label;
        });
        const auto index = static_cast<std::size_t>(known - all.begin());
        if (known == all.end())
            all.push_back(planner);
        else if (planner_text(*known) != planner_text(planner))
            refuse(next, "planner " + planner.label + " is " + planner_text(*known) + " here, " +
                             planner_text(planner) + " there");
        return index;
    }

    BenchmarkReport whole_;
    std::string first_file_;
    std::vector<BenchmarkSession> sessions_;
    std::map<RunPlace, std::string> owners_;
};

}  // namespace

BenchmarkReport merged(std::vector<NamedReport> reports) {
    Merger merger(std::move(reports.front()));
    for (std::size_t i = 1; i < reports.size(); ++i) merger.add(reports[i]);
    return merger.end();
}

}  // namespace asv::io
