#include "core/solve/stages/improve_path.hpp"

#include <limits>
#include <mutex>
#include <stop_token>

#include "core/solve/stages/in_threads.hpp"
#include "core/solve/stages/progress_report.hpp"

namespace asv::core {

namespace {

/// Microseconds of work for --optimize 0: shortcuts that take less time than writing what they
/// save.
constexpr double cheap_work = 2000;
/// The same for a mended path, most of which has been shortened before.
constexpr double cheap_work_mended = 1000;
/// Other paths are looked for with so many times the iterations of the first search, and so many
/// more: searches that take much longer than that one are not worth their time.
constexpr std::size_t iterations_factor = 3, iterations_more = 200;

class PathImprovement {
  public:
    PathImprovement(const SolveCall& call, const RaceResult& first, SolveStatistics& statistics)
        : call_(call),
          first_(first),
          statistics_(statistics),
          report_(call),
          deadline_(call.deadline()),
          stop_by_caller_(call.options.stop, [this] { stop_.request_stop(); }) {}

    Configurations run() {
        in_threads(call_.threads(), stop_, [this](std::size_t thread) { improve(thread); });
        return std::move(best_path_);
    }

  private:
    void improve(std::size_t thread) {
        // As in the race: too late to be of use.
        if (thread > 0 && order(thread).limits.expired()) return;
        // Not the draws of the search that found the path.
        Rng rng(~call_.seed(*first_.winner + thread));
        Improved improved = call_.solver.improve(first_.path, order(thread), rng);
        const double cost = call_.frame.cost_back(call_.solver.cost(improved.path));
        const std::lock_guard lock(mutex_);
        statistics_.state_checks += improved.checks.state_checks;
        statistics_.edge_checks += improved.checks.edge_checks;
        statistics_.optimal = statistics_.optimal || improved.optimal;
        // One is enough.
        if (improved.optimal) stop_.request_stop();
        if (cost >= best_) return;
        best_ = cost;
        best_path_ = std::move(improved.path);
    }

    ImprovementOrder order(std::size_t thread) {
        ImprovementOrder order;
        order.work =
            (first_.mended ? cheap_work_mended : cheap_work) + 1e6 * call_.options.optimize;
        order.other_paths = call_.options.optimize > 0;
        order.limits.deadline = deadline_;
        order.limits.stop = stop_.get_token();
        order.search_limits = order.limits;
        order.search_limits.max_iterations =
            iterations_factor * statistics_.iterations + iterations_more;
        order.on_better = [this, thread](double cost) {
            note_better(call_.frame.cost_back(cost), thread == 0);
        };
        return order;
    }

    /// Keeps the history of the best cost of all threads; the first one reports.
    void note_better(double cost, bool reports) {
        const double elapsed = call_.clock.elapsed();
        const std::lock_guard lock(mutex_);
        auto& history = statistics_.cost_history;
        if (cost < history.back().second) history.emplace_back(elapsed, cost);
        if (reports) report_.tell({}, history.back().second);
    }

    const SolveCall& call_;
    const RaceResult& first_;
    SolveStatistics& statistics_;
    ProgressReport report_;
    Clock::time_point deadline_;
    std::stop_source stop_;
    std::stop_callback<std::function<void()>> stop_by_caller_;
    std::mutex mutex_;  ///< of the statistics and the best path
    double best_ = std::numeric_limits<double>::infinity();
    Configurations best_path_;
};

}  // namespace

Configurations improve_path(const SolveCall& call, const RaceResult& first,
                            SolveStatistics& statistics) {
    return PathImprovement(call, first, statistics).run();
}

}  // namespace asv::core
