#pragma once

#include <exception>
#include <limits>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

#include "core/solve/solve.hpp"
#include "tools/mpi/solve/race_bytes.hpp"

namespace asv::tools {

/// What one rank does in a race: it solves the problem, in threads of its own, while another thread
/// listens to the other ranks and asks how far it is.
class Racer {
  public:
    /// Begins. The options' observers are called as ever; their stop is not looked at.
    /// Precondition: the problem outlives this.
    Racer(const core::Problem& problem, core::SolveOptions options);
    ~Racer() { stop(); }
    Racer(const Racer&) = delete;
    Racer& operator=(const Racer&) = delete;

    /// The path that its own search has found, in primitive steps; nullptr as long as there is
    /// none.
    const core::Path* first_path() const;
    /// Of the best path so far; infinite as long as there is none.
    double best_cost() const;
    bool has_ended() const;

    /// Where there is no path yet: gives up the search, and improves this one with draws of its
    /// own.
    void go_on_from(core::Path path);
    /// Comes to an end soon; the best path so far is kept.
    void stop();

    /// Precondition: it has ended. result() throws what solving has thrown; finish() tells it.
    const core::SolveResult& result() const;
    RaceFinish finish() const;

  private:
    void work(const core::Problem& problem, core::SolveOptions options);
    core::SolveResult solve(const core::Problem& problem, core::SolveOptions options);
    core::SolveOptions observed(core::SolveOptions options);

    mutable std::mutex mutex_;  ///< of all that follows, but for the stop sources
    bool has_path_ = false;
    std::optional<core::Path> first_path_;
    std::optional<core::Path> path_of_others_;
    double best_cost_ = std::numeric_limits<double>::infinity();
    bool has_ended_ = false;
    core::SolveResult result_;
    std::exception_ptr failure_;
    std::stop_source stop_search_, stop_;
    std::jthread thread_;
};

}  // namespace asv::tools
