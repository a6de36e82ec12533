#include "core/solve/stages/race.hpp"

#include <algorithm>
#include <atomic>
#include <limits>
#include <mutex>
#include <optional>
#include <stop_token>
#include <tuple>
#include <vector>

#include "core/bounds/feasibility.hpp"
#include "core/bounds/passages/passage_check.hpp"
#include "core/model/planning_window.hpp"
#include "core/solve/stages/in_threads.hpp"
#include "core/solve/stages/progress_report.hpp"
#include "core/solve/stages/tree_pictures.hpp"

namespace asv::core {

namespace {

using CostHistory = decltype(SolveStatistics::cost_history);

double best_cost(const CostHistory& history) {
    return history.empty() ? std::numeric_limits<double>::infinity() : history.back().second;
}

/// Seconds of search after which a proof that there is no path is looked for, some of them for each
/// obstacle: about what the proof itself takes.
double easy_search(const Problem& problem) {
    return 0.2 + 2e-5 * static_cast<double>(problem.obstacles.size());
}

class Race {
  public:
    Race(const SolveCall& call, SolveResult& result)
        : call_(call),
          result_(result),
          report_(call),
          deadline_(call.deadline()),
          stop_by_caller_(call.options.stop, [this] { stop_.request_stop(); }) {}

    RaceResult run() {
        in_threads(call_.threads(), stop_, [this](std::size_t thread) { search(thread); });
        return std::move(race_);
    }

  private:
    void search(std::size_t thread) {
        // A thread that the system is late to start need not prepare for a race that is over.
        if (thread > 0 && stop_.stop_requested()) return;
        Limits limits;
        limits.deadline = deadline_;
        limits.max_iterations = call_.options.max_iterations;
        limits.stop = stop_.get_token();
        Rng rng(call_.seed(thread));
        CostHistory history;
        const auto observer = [&](Progress progress) {
            progress.cost = call_.frame.cost_back(progress.cost);
            if (progress.cost < best_cost(history))
                history.emplace_back(call_.clock.elapsed(), progress.cost);
            if (thread == 0) watch(progress);
        };
        Attempt attempt = call_.solver.search(limits, rng, observer, call_.racer(thread));
        const std::lock_guard lock(mutex_);
        result_.statistics.state_checks += attempt.checks.state_checks;
        result_.statistics.edge_checks += attempt.checks.edge_checks;
        if (race_.winner) return;
        const bool solved = attempt.search.outcome == Outcome::solved;
        if (solved || thread == 0) note_search(attempt.search);
        if (solved) win(thread, std::move(attempt.search.path), std::move(history));
    }

    /// Reports progress and, once the search turns out not to be easy, looks for a proof that it is
    /// in vain. The search itself never sees either.
    void watch(const Progress& progress) {
        const double easy = easy_search(call_.problem);
        const bool worth_it = call_.clock.time_limit() > 10 * easy;
        const bool nothing_left = passage_check_ && passage_check_->finished();
        if (worth_it && !nothing_left && call_.clock.elapsed() > easy) look_for_proof();
        end_in_time_for_trees(progress);
        report_.tell(progress, std::nullopt);
    }

    /// What is quick at once; passages bit by bit, so that the search keeps most of the time, and
    /// not so late that a bit could take longer than is left.
    void look_for_proof() {
        Feasibility proof;
        if (!passage_check_) {
            proof = check_separation(call_.problem);
            passage_check_.emplace(bounded(call_.problem));
        } else if (seconds_of_proof_ < share_of_proof() * call_.clock.elapsed() &&
                   call_.clock.left() > longest_bit) {
            const double begin = call_.clock.elapsed();
            proof = passage_check_->work(cells_at_a_time);
            seconds_of_proof_ += call_.clock.elapsed() - begin;
        }
        if (proof.cause == Infeasibility::none) return;
        race_.infeasible = proof.reason;
        stop_.request_stop();
    }

    /// Of the time of the first thread: less where no other searches meanwhile.
    double share_of_proof() const { return call_.threads() > 1 ? 0.5 : 0.25; }

    /// Trees have to be drawn and written inside the limit as well, the longer the more there is of
    /// them.
    void end_in_time_for_trees(const Progress& progress) {
        if (!call_.options.keep_trees) return;
        const auto nodes = static_cast<double>(progress.nodes[0] + progress.nodes[1]);
        const double least = std::min(0.02, 0.25 * call_.clock.time_limit());
        if (call_.clock.left() > least + seconds_per_node * nodes) return;
        out_of_time_ = true;
        stop_.request_stop();
    }

    /// Of the search that won or, as long as none has, of that of the first thread.
    void note_search(const SearchResult& search) {
        race_.failure =
            out_of_time_ && search.outcome == Outcome::stopped ? Outcome::deadline : search.outcome;
        SolveStatistics& statistics = result_.statistics;
        statistics.iterations = search.iterations;
        for (std::size_t side = 0; side < search.trees.size(); ++side)
            statistics.tree_nodes[side] = search.trees[side].size();
        if (!call_.options.keep_trees) return;
        result_.trees = draw_trees(search, call_);
        result_.edges = search.edges;
    }

    void win(std::size_t thread, Configurations path, CostHistory history) {
        race_.winner = thread;
        stop_.request_stop();
        race_.path = std::move(path);
        SolveStatistics& statistics = result_.statistics;
        statistics.cost_of_search = call_.frame.cost_back(call_.solver.cost(race_.path));
        if (statistics.cost_of_search < best_cost(history))
            history.emplace_back(call_.clock.elapsed(), statistics.cost_of_search);
        if (call_.options.on_path) call_.options.on_path(history.front().first);
        std::tie(statistics.time_to_first, statistics.cost_first) = history.front();
        statistics.cost_history = std::move(history);
    }

    /// To draw a node of a tree, or of a roadmap with its edges, and to write it.
    static constexpr double seconds_per_node = 4e-6;
    /// Of chains, for the check of passages: some milliseconds.
    static constexpr std::size_t cells_at_a_time = 2000;
    /// Seconds that one bit of that check takes at the very most.
    static constexpr double longest_bit = 0.5;

    const SolveCall& call_;
    SolveResult& result_;
    ProgressReport report_;
    Clock::time_point deadline_;
    std::optional<PassageCheck> passage_check_;  ///< once all that is quick has been looked at
    double seconds_of_proof_ = 0;                ///< spent on that
    std::atomic<bool> out_of_time_ = false;
    std::stop_source stop_;
    std::stop_callback<std::function<void()>> stop_by_caller_;
    std::mutex mutex_;  ///< of race_ and result_
    RaceResult race_;
};

}  // namespace

RaceResult race_for_first_path(const SolveCall& call, SolveResult& result) {
    return Race(call, result).run();
}

}  // namespace asv::core
