#include "tools/mpi/solve/racer.hpp"

#include <algorithm>
#include <utility>

#include "core/solve/replan.hpp"

namespace asv::tools {

Racer::Racer(const core::Problem& problem, core::SolveOptions options)
    : thread_(
          [this, &problem, options = observed(std::move(options))] { work(problem, options); }) {}

core::SolveOptions Racer::observed(core::SolveOptions options) {
    options.on_path = [this, tell = std::move(options.on_path)](double seconds) {
        if (tell) tell(seconds);
        const std::lock_guard lock(mutex_);
        has_path_ = true;
    };
    options.on_first_path = [this](const core::Path& path) {
        const std::lock_guard lock(mutex_);
        first_path_ = path;
    };
    options.on_progress =
        [this, tell = std::move(options.on_progress)](const core::SolveProgress& progress) {
            if (tell) tell(progress);
            const std::lock_guard lock(mutex_);
            if (progress.cost) best_cost_ = std::min(best_cost_, *progress.cost);
        };
    return options;
}

void Racer::work(const core::Problem& problem, core::SolveOptions options) {
    core::SolveResult result;
    std::exception_ptr failure;
    try {
        result = solve(problem, std::move(options));
    } catch (...) {
        failure = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    result_ = std::move(result);
    failure_ = failure;
    has_ended_ = true;
}

core::SolveResult Racer::solve(const core::Problem& problem, core::SolveOptions options) {
    const auto begun = core::Clock::now();
    options.stop = stop_search_.get_token();
    core::SolveResult own = core::solve(problem, options);
    std::optional<core::Path> next;
    {
        const std::lock_guard lock(mutex_);
        next = std::move(path_of_others_);
    }
    if (!next || stop_.stop_requested() || own.status == core::SolveStatus::infeasible) return own;
    // The search may have come to a path of its own just when it was stopped.
    if (own.solution) next = own.solution->path;
    options.stop = stop_.get_token();
    options.elapsed_before += std::chrono::duration<double>(core::Clock::now() - begun).count();
    return core::replan(problem, *next, options);
}

const core::Path* Racer::first_path() const {
    const std::lock_guard lock(mutex_);
    return first_path_ ? &*first_path_ : nullptr;
}

double Racer::best_cost() const {
    const std::lock_guard lock(mutex_);
    return best_cost_;
}

bool Racer::has_ended() const {
    const std::lock_guard lock(mutex_);
    return has_ended_;
}

void Racer::go_on_from(core::Path path) {
    {
        const std::lock_guard lock(mutex_);
        if (has_path_ || has_ended_) return;
        path_of_others_ = std::move(path);
    }
    stop_search_.request_stop();
}

void Racer::stop() {
    stop_.request_stop();
    stop_search_.request_stop();
}

const core::SolveResult& Racer::result() const {
    const std::lock_guard lock(mutex_);
    if (failure_) std::rethrow_exception(failure_);
    return result_;
}

RaceFinish Racer::finish() const try {
    const core::SolveResult& ended = result();
    return {ended.status, ended.reason, {}, ended.statistics};
} catch (const std::exception& error) {
    return {core::SolveStatus::interrupted, {}, error.what(), {}};
}

}  // namespace asv::tools
