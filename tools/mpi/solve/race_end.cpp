#include "tools/mpi/solve/race_end.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/model/cost.hpp"
#include "core/validation/validate.hpp"

namespace asv::tools {

namespace {

using core::SolveStatus;

/// A cost so little above a bound, as a share, is proven to be the least.
constexpr double proven_share = 1e-5;

bool solved(const std::optional<RaceFinish>& finish) {
    return finish && finish->status == SolveStatus::solved;
}

}  // namespace

bool is_decided(const Finishes& finishes, double best_cost) {
    double bound = 0;
    for (const auto& finish : finishes) {
        if (!finish) continue;
        if (finish->spent.optimal || finish->status == SolveStatus::infeasible ||
            !finish->failure.empty())
            return true;
        bound = std::max(bound, finish->spent.cost_lower_bound);
    }
    return bound > 0 && best_cost <= bound * (1 + proven_share);
}

std::optional<int> best_rank(const Finishes& finishes) {
    std::optional<std::size_t> best;
    for (std::size_t rank = 0; rank < finishes.size(); ++rank)
        if (solved(finishes[rank]) &&
            (!best || finishes[rank]->spent.cost < finishes[*best]->spent.cost))
            best = rank;
    if (!best) return std::nullopt;
    return static_cast<int>(*best);
}

void take_solution(const core::Problem& problem, core::Path path, const RaceFinish& finish,
                   core::SolveResult& result) {
    core::Solution solution{std::move(path), 0};
    solution.cost = core::cost(problem, solution.path);
    result.report =
        core::validate(problem, solution, {.tolerance = problem.requirements.tolerance});
    for (const core::CheckResult& check : result.report.checks)
        if (!check.ok())
            throw std::logic_error("the path of another rank fails the check of " +
                                   std::string(core::name(check.check)) + ": " +
                                   core::describe(check));
    result.status = finish.status;
    result.reason.clear();
    result.statistics = finish.spent;
    result.solution = std::move(solution);
}

void take_proof(const Finishes& finishes, core::SolveResult& result) {
    for (const auto& finish : finishes) {
        if (!finish || finish->status != SolveStatus::infeasible) continue;
        result.status = finish->status;
        result.reason = finish->reason;
        return;
    }
}

void take_statistics(const Finishes& finishes, core::SolveResult& result) {
    core::SolveStatistics& all = result.statistics;
    all.state_checks = all.edge_checks = 0;
    for (const auto& finish : finishes) {
        if (!finish) continue;
        all.state_checks += finish->spent.state_checks;
        all.edge_checks += finish->spent.edge_checks;
        all.optimal = all.optimal || finish->spent.optimal;
        all.cost_lower_bound = std::max(all.cost_lower_bound, finish->spent.cost_lower_bound);
        all.steps_lower_bound = std::max(all.steps_lower_bound, finish->spent.steps_lower_bound);
    }
}

void require_no_failure(const Finishes& finishes) {
    for (const auto& finish : finishes)
        if (finish && !finish->failure.empty())
            throw std::runtime_error("a rank has failed: " + finish->failure);
}

}  // namespace asv::tools
