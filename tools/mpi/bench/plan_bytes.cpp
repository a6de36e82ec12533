#include "tools/mpi/bench/plan_bytes.hpp"

#include <stdexcept>
#include <utility>

#include "io/benchmark/record/journal_text.hpp"
#include "io/problem/problem_digest.hpp"
#include "io/problem/scenario_file.hpp"
#include "io/problem/scenario_text.hpp"
#include "tools/bench/runs/run_bytes.hpp"

namespace asv::tools {

std::string plan_bytes(const core::BenchmarkPlan& plan) {
    io::BenchmarkReport report;
    report.plan = plan;
    // A journal has to have one.
    report.session.unit_before = report.session.unit_after = 1;
    Packer packer;
    packer(io::journal_head(report));
    for (const core::BenchmarkProblem& problem : plan.problems)
        packer(io::format_scenario(problem.problem));
    return packer.bytes();
}

core::BenchmarkPlan plan_of(std::string_view bytes) {
    Unpacker unpacker(bytes);
    std::string head, scenario;
    unpacker(head);
    core::BenchmarkPlan plan = io::parse_journal(head, "the plan of rank 0").value().report.plan;
    for (core::BenchmarkProblem& problem : plan.problems) {
        unpacker(scenario);
        problem.problem = io::parse_scenario(scenario, problem.name, {}).problem;
        if (io::problem_digest(problem.problem) != problem.digest)
            throw std::logic_error("problem " + problem.name + " has changed on its way");
    }
    return plan;
}

}  // namespace asv::tools
