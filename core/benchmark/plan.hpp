#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/model/problem.hpp"
#include "core/solve/solve.hpp"

/// What a benchmark shall run: every problem with every planner in every direction and every seed.

namespace asv::core {

enum class Direction { forward, reversed };

/// "forward", "reversed".
std::string_view name(Direction direction);

struct BenchmarkProblem {
    std::string name;  ///< what tables call it; no other problem of the plan has it
    std::string file;  ///< where it was read from, for commands that repeat a run
    Problem problem;
    /// Of its content: two problems with one digest are the same, whatever their files are called.
    std::string digest = {};
    /// Numbers that it was generated with, by their names; empty where nobody has told them.
    std::vector<std::pair<std::string, double>> parameters = {};
};

/// A planner with settings of its own.
struct BenchmarkPlanner {
    std::string label;  ///< what tables call it; no other planner of the plan has it
    Planner planner;
    std::vector<std::pair<std::string, std::string>> settings;  ///< what differs from the default
    /// Of another program that plans instead, whose runs are not those of run_once(): its words,
    /// with placeholders. Empty for the planners of this library.
    std::vector<std::string> command = {};

    bool external() const { return !command.empty(); }
};

/// The defaults are those of asv-bench.
struct BenchmarkPlan {
    std::vector<BenchmarkProblem> problems;
    std::vector<BenchmarkPlanner> planners;
    std::vector<Direction> directions = {Direction::forward};  ///< the way of the problem files
    std::uint64_t first_seed = 1;                              ///< any; that of asv-solve
    /// Runs of each planner, with first_seed, first_seed + 1, ..., 1 or more. Ten, as in the
    /// reports that are compared with.
    std::size_t seeds = 10;
    /// Wall clock of each run in seconds, 0 or more. A round number: the default planner needed
    /// some 1.1 s at worst on thousands of random problems.
    double time_limit = 10;
    /// Improvement after the first solution, in seconds of work as in SolveOptions, 0 or more.
    /// None: planners are compared by their first paths.
    double optimize = 0;
    std::size_t threads = 1;       ///< of each run, 1 or more; one, so that a seed decides the path
    std::size_t memory_limit = 0;  ///< megabytes (2^20 bytes) for each run; 0 for no limit
    std::size_t jobs = 1;  ///< runs side by side, 1 or more; one, since more spoil all times
};

/// Which one of the runs of a plan: indices into it.
struct RunPlace {
    std::size_t problem = 0;
    std::size_t planner = 0;
    Direction direction = Direction::forward;
    std::uint64_t seed = 1;

    friend auto operator<=>(const RunPlace&, const RunPlace&) = default;
};

/// All runs by problem, direction, planner and seed: the order in which they are told.
std::vector<RunPlace> places(const BenchmarkPlan& plan);

/// How many there are.
std::size_t run_count(const BenchmarkPlan& plan);

/// The options of the run, exactly those of asv-solve with the same arguments; its clock starts
/// now.
SolveOptions solve_options(const BenchmarkPlan& plan, const RunPlace& place);

}  // namespace asv::core
