#include "tools/bench/records/earlier_runs.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

#include "io/benchmark/record/merge.hpp"
#include "io/benchmark/record/runs_file.hpp"
#include "io/text/escape.hpp"
#include "tools/common/command_line.hpp"

namespace asv::tools {

io::BenchmarkReport earlier_runs(const std::vector<std::string>& files) {
    std::vector<io::NamedReport> reports;
    for (const std::string& file : files) reports.push_back({file, io::read_runs(file)});
    try {
        return io::merged(std::move(reports));
    } catch (const io::MergeError& error) {
        throw UsageError("--from: " + io::escaped(error.what()));
    }
}

std::vector<std::size_t> add_planners(io::BenchmarkReport& report,
                                      const std::vector<core::BenchmarkPlanner>& planners) {
    auto& all = report.plan.planners;
    std::vector<std::size_t> indices;
    for (const core::BenchmarkPlanner& planner : planners) {
        const auto known = std::find_if(all.begin(), all.end(), [&](const auto& candidate) {
            return candidate.label == planner.label;
        });
        indices.push_back(static_cast<std::size_t>(known - all.begin()));
        if (known == all.end())
            all.push_back(planner);
        else if (io::planner_text(*known) != io::planner_text(planner))
            throw UsageError("planner " + planner.label + " is " + io::planner_text(planner) +
                             " here, " + io::escaped(io::planner_text(*known)) +
                             " in the files of --from; give it another label");
    }
    return indices;
}

std::vector<std::string> problem_files(const core::BenchmarkPlan& plan) {
    std::vector<std::string> files;
    for (const core::BenchmarkProblem& problem : plan.problems) files.push_back(problem.file);
    return files;
}

void put_in_place(std::vector<core::BenchmarkProblem> read, core::BenchmarkPlan& plan) {
    for (std::size_t i = 0; i < read.size(); ++i) {
        if (read[i].digest != plan.problems[i].digest)
            throw UsageError(read[i].file + " is not the problem that the runs of --from are of: " +
                             "its content has changed");
        plan.problems[i].problem = std::move(read[i].problem);
    }
}

std::vector<core::RunPlace> missing_runs(const io::BenchmarkReport& report,
                                         const std::vector<std::size_t>& planners) {
    const std::set<std::size_t> wanted(planners.begin(), planners.end());
    std::set<core::RunPlace> done;
    for (const core::BenchmarkRun& run : report.runs) done.insert(run.place);
    std::vector<core::RunPlace> missing;
    for (const core::RunPlace& place : core::places(report.plan))
        if (wanted.contains(place.planner) && !done.contains(place)) missing.push_back(place);
    return missing;
}

std::vector<core::RunPlace> missing_runs(const io::BenchmarkReport& report) {
    std::vector<std::size_t> all(report.plan.planners.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return missing_runs(report, all);
}

}  // namespace asv::tools
