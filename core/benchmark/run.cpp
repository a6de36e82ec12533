#include "core/benchmark/run.hpp"

#include <algorithm>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <stop_token>
#include <tuple>
#include <utility>

#include "core/solve/stages/in_threads.hpp"
#include "core/validation/validate.hpp"

namespace asv::core {

namespace {

auto told_order(const RunPlace& place) {
    return std::tuple(place.problem, place.direction, place.planner, place.seed);
}

/// The order in which they are run: planners side by side.
auto run_order(const RunPlace& place) {
    return std::tuple(place.problem, place.seed, place.direction, place.planner);
}

void require_runnable(const BenchmarkPlan& plan) {
    for (const BenchmarkProblem& problem : plan.problems) {
        for (const BenchmarkPlanner& planner : plan.planners)
            if (!planner.external()) require_usable(planner.planner, problem.problem.body_kind());
        if (const auto invalid = invalid_ends(problem.problem); !invalid.empty())
            throw std::invalid_argument(problem.name + ": " + (invalid[0].goal ? "goal" : "start") +
                                        " is not valid: " + invalid[0].reason);
    }
}

/// The runs that are still to do, shared by the jobs.
class Queue {
  public:
    Queue(const BenchmarkPlan& plan, std::vector<RunPlace> which, const BenchmarkWatch& watch)
        : plan_(plan), watch_(watch), places_(std::move(which)) {
        std::stable_sort(places_.begin(), places_.end(), [](const RunPlace& a, const RunPlace& b) {
            return run_order(a) < run_order(b);
        });
    }

    void work() {
        try {
            while (const std::optional<RunPlace> place = next())
                keep(watch_.perform(plan_, *place, watch_.abort));
        } catch (...) {
            // One job after the other, so that the caller gets what the first one met.
            const std::lock_guard lock(mutex_);
            if (!failure_) failure_ = std::current_exception();
            finished_ = true;
        }
    }

    std::vector<BenchmarkRun> results() {
        if (failure_) std::rethrow_exception(failure_);
        sort_as_told(runs_);
        return std::move(runs_);
    }

  private:
    std::optional<RunPlace> next() {
        const std::lock_guard lock(mutex_);
        const bool stopped = watch_.enough.stop_requested() || watch_.abort.stop_requested();
        if (finished_ || stopped || next_ == places_.size()) return std::nullopt;
        const RunPlace& place = places_[next_++];
        if (watch_.before) watch_.before(place);
        return place;
    }

    void keep(BenchmarkRun run) {
        const std::lock_guard lock(mutex_);
        // What was cut off says nothing of the planner.
        if (watch_.abort.stop_requested() && run.fault.empty()) return;
        if (watch_.after) watch_.after(run);
        finished_ = finished_ || !run.fault.empty();
        runs_.push_back(std::move(run));
    }

    const BenchmarkPlan& plan_;
    const BenchmarkWatch& watch_;
    std::mutex mutex_;
    std::vector<RunPlace> places_;
    std::size_t next_ = 0;
    bool finished_ = false;
    std::exception_ptr failure_;
    std::vector<BenchmarkRun> runs_;
};

}  // namespace

std::string_view name(RunStatus status) {
    switch (status) {
        case RunStatus::solved:
            return "solved";
        case RunStatus::timeout:
            return "timeout";
        case RunStatus::infeasible:
            return "infeasible";
        case RunStatus::interrupted:
            return "interrupted";
        case RunStatus::no_path:
            return "no-path";
        case RunStatus::memory_limit:
            return "memory-limit";
        case RunStatus::crash:
            return "crash";
        case RunStatus::invalid:
            return "invalid";
    }
    return "unknown";
}

RunStatus run_status(SolveStatus status) {
    switch (status) {
        case SolveStatus::solved:
            return RunStatus::solved;
        case SolveStatus::timeout:
            return RunStatus::timeout;
        case SolveStatus::infeasible:
            return RunStatus::infeasible;
        case SolveStatus::interrupted:
            return RunStatus::interrupted;
    }
    throw std::logic_error("a status that solve() does not have");
}

BenchmarkRun run_once(const BenchmarkPlan& plan, const RunPlace& place,
                      const std::stop_token& abort) {
    BenchmarkRun run;
    run.place = place;
    const Problem& problem = plan.problems[place.problem].problem;
    SolveOptions options = solve_options(plan, place);
    options.stop = abort;
    try {
        const SolveResult result = solve(problem, options);
        run.status = run_status(result.status);
        run.reason = result.reason;
        run.spent = result.statistics;
        if (result.solution) {
            run.primitive_steps = result.solution->path.size() - 1;
            run.fault = fault_of(problem, *result.solution);
        }
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        run.fault = error.what();
    }
    return run;
}

std::vector<BenchmarkRun> run_benchmark(const BenchmarkPlan& plan, const BenchmarkWatch& watch) {
    return run_benchmark(plan, places(plan), watch);
}

std::vector<BenchmarkRun> run_benchmark(const BenchmarkPlan& plan, std::vector<RunPlace> which,
                                        const BenchmarkWatch& watch) {
    require_runnable(plan);
    Queue queue(plan, std::move(which), watch);
    in_threads(watch.workers > 0 ? watch.workers : plan.jobs, std::stop_source(),
               [&queue](std::size_t /*job*/) { queue.work(); });
    return queue.results();
}

void sort_as_told(std::vector<BenchmarkRun>& runs) {
    std::sort(runs.begin(), runs.end(), [](const BenchmarkRun& a, const BenchmarkRun& b) {
        return told_order(a.place) < told_order(b.place);
    });
}

std::string fault_of(const Problem& problem, const Solution& solution) {
    const ValidationReport report = validate(
        problem, solution, {.tolerance = problem.requirements.tolerance, .continuous = true});
    for (const auto* checks : {&report.checks, &report.motion})
        for (const CheckResult& check : *checks)
            if (!check.ok())
                return std::string(checks == &report.motion ? "motion: " : "") +
                       std::string(name(check.check)) + ": " + describe(check);
    return {};
}

}  // namespace asv::core
