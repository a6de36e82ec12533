#include "core/solve/solve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "core/bounds/feasibility.hpp"
#include "core/model/cost.hpp"
#include "core/model/planning_window.hpp"
#include "core/solve/planning_obstacles.hpp"
#include "core/solve/replan.hpp"
#include "core/solve/stages/find_bounds.hpp"
#include "core/solve/stages/improve_path.hpp"
#include "core/solve/stages/mend_path.hpp"
#include "core/solve/stages/race.hpp"
#include "core/solve/stages/solve_call.hpp"
#include "core/validation/validate.hpp"

namespace asv::core {

namespace {

/// Seconds of processor time to keep for turning a path into steps, checking and writing it: some 5
/// sides of the field for each ASV, in steps of the greatest length, at thrice the half microsecond
/// that each position takes; and for all threads to notice that they have to end.
double time_to_finish(const Problem& problem, const SolveOptions& options) {
    const Box window = planning_window(problem);
    const double side = std::max(window.high.x - window.low.x, window.high.y - window.low.y);
    const double positions =
        5 * side / problem.requirements.max_step * static_cast<double>(problem.asv_count());
    const auto obstacles = static_cast<double>(problem.obstacles.size());
    const auto threads = static_cast<double>(options.threads);
    return 0.015 + 1.5e-6 * positions + 4e-6 * obstacles + 2e-4 * threads;
}

/// Seconds to write a path as text.
double time_to_write(const Path& path) {
    return 0.002 + 3e-7 * static_cast<double>(path.size() * path.asv_count());
}

SolveResult infeasible(std::string reason) {
    SolveResult result;
    result.status = SolveStatus::infeasible;
    result.reason = std::move(reason);
    return result;
}

/// How far the coordinates of a path, and the turns of an arm along it, may be off by rounding:
/// some times the last bit of the largest, for each ASV and step.
double rounding_of(const Problem& problem, const Path& path) {
    constexpr double unit_roundoff = 0x1p-53, roundings = 16;
    const Box window = planning_window(problem);
    double size = problem.arm() ? 2 * std::numbers::pi : 0;
    for (const Point& corner : {window.low, window.high})
        size = std::max({size, std::abs(corner.x), std::abs(corner.y)});
    return roundings * unit_roundoff * size * static_cast<double>(path.asv_count() * path.size());
}

/// The path is right, but for its last bits, which nobody can write down better.
void note_tolerance_too_small(const Problem& problem, const CheckResult& failed,
                              SolveResult& result) {
    std::ostringstream reason;
    reason
        << "a path was found, but its coordinates, as they are rounded, do not keep a tolerance of "
        << problem.requirements.tolerance << ": " << describe(failed);
    result.status = SolveStatus::timeout;
    result.reason = reason.str();
}

/// Makes the path the given problem's solution, which the validator's own code has passed.
void check_solution(const SolveCall& call, Path path, SolveResult& result) {
    const Problem& problem = call.problem;
    Solution solution{std::move(path), 0};
    solution.cost = cost(problem, solution.path);
    result.report = validate(
        problem, solution,
        {.tolerance = problem.requirements.tolerance, .continuous = call.options.certify_motion});
    for (const CheckResult& check : result.report.checks) {
        if (check.ok()) continue;
        if (problem.requirements.tolerance < rounding_of(problem, solution.path))
            return note_tolerance_too_small(problem, check, result);
        throw std::logic_error("the path found fails the check of " +
                               std::string(name(check.check)) + ": " + describe(check));
    }
    result.solution = std::move(solution);
    result.status = SolveStatus::solved;
}

/// The last cost of the history is that of the solution, which differs a little from that of the
/// configurations it was made of; no earlier one is below it.
void note_cost(double cost, double elapsed, SolveStatistics& statistics) {
    statistics.cost = cost;
    statistics.cost_first = std::max(statistics.cost_first, cost);
    auto& history = statistics.cost_history;
    for (auto& entry : history) entry.second = std::max(entry.second, cost);
    const auto same = [](const auto& a, const auto& b) { return !(b.second < a.second); };
    history.erase(std::unique(history.begin(), history.end(), same), history.end());
    if (history.empty() || history.back().second > cost) history.emplace_back(elapsed, cost);
}

/// Improves the first path, turns it into steps and checks them.
void finish(const SolveCall& call, const RaceResult& first, SolveResult& result) {
    const Configurations best = improve_path(call, first, result.statistics);
    const std::optional<Path> steps = call.solver.steps(best, call.clock.moment_before_end(0));
    if (!steps) {
        result.status = SolveStatus::timeout;
        result.reason = "a path was found after " +
                        std::to_string(result.statistics.time_to_first) +
                        " s, but the time is up before it is turned into primitive steps";
        return;
    }
    check_solution(call, call.frame.path_back(*steps), result);
    if (!result.solution) return;
    result.corners = call.frame.placements_back(call.solver.placements(best));
    note_cost(result.solution->cost, call.clock.elapsed(), result.statistics);
    if (call.options.find_bounds)
        find_bounds(call, time_to_write(result.solution->path), result.statistics);
}

/// Shows the path of the search to the caller, where that wants to see it.
void show_first_path(const SolveCall& call, const RaceResult& first) {
    if (!call.options.on_first_path) return;
    if (const auto steps = call.solver.steps(first.path, call.deadline()))
        call.options.on_first_path(call.frame.path_back(*steps));
}

/// Mends the last path, if there is one, or else searches; improves and checks.
void plan(const SolveCall& call, const Path* last, SolveResult& result) {
    if (last) {
        if (const auto mended = mend_path(call, *last, result.statistics))
            return finish(call, *mended, result);
    }
    const RaceResult first = race_for_first_path(call, result);
    if (first.infeasible) {
        result.status = SolveStatus::infeasible;
        result.reason = *first.infeasible;
    } else if (!first.winner) {
        const bool stopped = call.options.stop.stop_requested();
        result.status = stopped ? SolveStatus::interrupted : SolveStatus::timeout;
        result.reason = "no path found: " + std::string(name(first.failure));
    } else {
        show_first_path(call, first);
        finish(call, first, result);
    }
}

}  // namespace

SolveResult solve_among(const PlanningObstacles* prepared, const Path* last, const Problem& problem,
                        const SolveOptions& options) {
    const SolveClock clock(options.time_limit, options.elapsed_before);
    require_usable(options.planner, problem.body_kind());
    if (auto proof = check_area(problem); proof.cause != Infeasibility::none)
        return infeasible(std::move(proof.reason));
    std::optional<PlanningFrame> frame;
    if (prepared) frame.emplace(problem, options.reverse);
    auto invalid = prepared ? prepared->find_invalid_ends(problem, *frame) : invalid_ends(problem);
    if (!invalid.empty()) throw InvalidEnds(std::move(invalid));
    if (auto proof = check_orientation(problem); proof.cause != Infeasibility::none)
        return infeasible(std::move(proof.reason));

    if (!frame) frame.emplace(problem, options.reverse);
    const auto solver = make_body_solver(frame->problem(), options.planner,
                                         prepared ? prepared->in(*frame) : nullptr);
    SolveResult result;
    plan({problem, options, clock, *frame, *solver, time_to_finish(problem, options)}, last,
         result);
    result.statistics.time_total = clock.elapsed();
    return result;
}

SolveResult solve(const Problem& problem, const SolveOptions& options) {
    return solve_among(nullptr, nullptr, problem, options);
}

SolveResult replan(const Problem& problem, const Path& last_path, const SolveOptions& options) {
    return solve_among(nullptr, &last_path, problem, options);
}

}  // namespace asv::core
