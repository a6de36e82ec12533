#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <vector>

#include "core/model/path.hpp"
#include "core/model/problem.hpp"
#include "core/search/search_result.hpp"
#include "core/solve/planner_catalogue.hpp"
#include "core/solve/solve_result.hpp"

/// The façade: a problem goes in, a checked solution comes out.

namespace asv::core {

/// A look at the work while it runs.
struct SolveProgress {
    Progress search;             ///< of the first thread's search
    std::optional<double> cost;  ///< of the best path, once there is one
    double elapsed = 0;          ///< seconds
};

/// What solve() is asked for. Options can serve any number of calls.
struct SolveOptions {
    /// The algorithm and its settings; `auto` solves most and solves it soonest.
    Planner planner = AutoPlanner{};
    /// Of all random draws, any number. The same seed gives the same path with one thread.
    std::uint64_t seed = 1;
    /// Seconds of wall clock for everything, 0 or more: a minute, since hard problems take seconds.
    double time_limit = 60;
    /// Iterations of each thread's search, 1 or more: no limit, since time is what most have. With
    /// it the end of a search in vain is the same on every machine.
    std::size_t max_iterations = std::numeric_limits<std::size_t>::max();
    /// Seconds of improvement after the first path, 0 or more; counted as work of a 2.8 GHz core,
    /// not timed, so that the same seed gives the same path. One brings most problems close to the
    /// best that is known. 0: only the shortcuts that cost less time than writing what they save.
    double optimize = 1;
    /// Threads that race with different seeds and strategies, then improve; 0 counts as 1, and more
    /// than 8 for each processor as 8. Fewer are started where the system grants no more. One,
    /// since several find another path each time.
    std::size_t threads = 1;
    /// Racers are numbered through all threads, and each number has draws and strategies of its
    /// own. Where several processes race on one problem with one seed, the number of the first
    /// thread of each: how many threads the processes before it have.
    std::size_t first_racer = 0;
    /// Plan from the goal to the start; the path is given from the start to the goal all the same.
    bool reverse = false;
    /// Fill SolveResult::trees, which takes memory.
    bool keep_trees = false;
    /// Let the validator certify the motion between the primitive steps as well, which takes longer
    /// than all its other checks; its verdict is in SolveResult::report. Off: the assignment asks
    /// of states.
    bool certify_motion = false;
    /// Find the lower bounds of cost and steps. Who follows a problem that moves has no time for
    /// them, and finds the same bounds of one problem only once.
    bool find_bounds = true;
    /// Seconds that the caller has spent on this problem before the call (reading it, for example):
    /// they count toward the time limit and toward every time that is reported.
    double elapsed_before = 0;
    /// Ends the work early; the best path so far is kept.
    std::stop_token stop = {};
    /// Called from the thread of the first search, some ten times a second.
    std::function<void(const SolveProgress&)> on_progress = {};
    /// Called once there is a path, by the thread that has found it, with the seconds that took.
    std::function<void(double)> on_path = {};
    /// Called, where it is given, with the path that the search has found, as primitive steps from
    /// the start to the goal, before it is improved; not checked by the validator yet. To make the
    /// steps of a path that is not yet short takes time.
    std::function<void(const Path&)> on_first_path = {};
};

/// A requirement that the start or the goal of a problem violates.
struct InvalidEnd {
    bool goal = false;  ///< of the goal, else of the start
    std::string reason;
};

/// Start or goal of a problem violate requirements.
class InvalidEnds : public std::invalid_argument {
  public:
    /// Precondition: not empty.
    explicit InvalidEnds(std::vector<InvalidEnd> ends);
    const std::vector<InvalidEnd>& ends() const { return ends_; }

  private:
    std::vector<InvalidEnd> ends_;
};

/// Which end of the problem is not valid and why: which requirement, which ASV, broom or obstacle,
/// by how much; empty when both are valid, or when no chain of so many ASVs could be.
std::vector<InvalidEnd> invalid_ends(const Problem& problem);

/// Plans, improves and checks. The same options with one thread and enough time give the same
/// solution, byte for byte. Each call has a clock of its own, which starts with it. A tolerance so
/// small that no coordinates keep it once they are rounded ends without a solution, as a timeout
/// that tells this reason.
/// Throws InvalidEnds when start or goal is not valid, std::invalid_argument when an option makes
/// no sense for the body, std::logic_error when the validator rejects the path that was found (a
/// bug), and std::bad_alloc when there is no memory, in whatever thread.
SolveResult solve(const Problem& problem, const SolveOptions& options = {});

}  // namespace asv::core
