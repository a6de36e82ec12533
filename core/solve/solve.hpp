#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/path.hpp"
#include "core/model/problem.hpp"
#include "core/search/limits.hpp"
#include "core/solve/planner_catalogue.hpp"

/// The façade: a problem goes in, a checked solution comes out.

namespace asv::core {

/// A look at the work while it runs.
struct SolveProgress {
    Progress search;             ///< of the first thread's search
    std::optional<double> cost;  ///< of the best path, once there is one
    double elapsed = 0;          ///< seconds
};

struct SolveOptions {
    Planner planner = AutoPlanner{};
    std::uint64_t seed = 1;
    double time_limit = 60;   ///< seconds from `started` for everything
    double optimize = 1;      ///< seconds of improvement after the first solution
    std::size_t threads = 1;  ///< that race different seeds, then improve; 0 counts as 1
    bool reverse = false;     ///< plan from goal to start; the path is given from start to goal
    bool keep_trees = false;  ///< fill SolveResult::trees
    Clock::time_point started = Clock::now();
    std::stop_token stop = {};  ///< ends the work early; the best solution so far is kept
    /// Called from the thread of the first search, some times a second at most.
    std::function<void(const SolveProgress&)> on_progress = {};
};

enum class SolveStatus { solved, timeout, infeasible, interrupted };

/// "solved", "timeout", "infeasible", "interrupted".
std::string_view name(SolveStatus status);

/// A requirement that the start or the goal of a problem violates.
struct InvalidEnd {
    bool goal = false;  ///< of the goal, else of the start
    std::string reason;
};

/// Where a tree has its root; the nodes of a roadmap are all roots.
enum class TreeRoot { start, goal, roadmap };

/// "start", "goal", "roadmap".
std::string_view name(TreeRoot root);

/// A search tree as a picture shows it: where ASV 1, the tip of an arm or the point is at each
/// node, and the node's parent.
struct TreePicture {
    TreeRoot root = TreeRoot::start;
    std::vector<geometry::Point> points;
    std::vector<std::int64_t> parents;  ///< -1 for the root
};

struct SolveStatistics {
    double time_to_first = 0, time_total = 0;  ///< seconds
    double cost_first = 0, cost = 0;           ///< workspace units
    double cost_of_search = 0;    ///< of the path that the search ended with, before any shortcut
    double cost_lower_bound = 0;  ///< no path costs less; 0 where there was no time for it
    std::size_t steps_lower_bound = 0;  ///< no path has fewer primitive steps; 0 where not known
    std::size_t tree_nodes[2] = {0, 0};
    std::size_t iterations = 0;
    std::uint64_t state_checks = 0, edge_checks = 0;
    /// (seconds, cost) whenever a better path was found.
    std::vector<std::pair<double, double>> cost_history;
};

struct SolveResult {
    SolveStatus status = SolveStatus::timeout;
    std::string reason;                ///< why there is no solution; empty when solved
    std::optional<Solution> solution;  ///< passed the validator
    SolveStatistics statistics;
    std::vector<TreePicture> trees;  ///< that of the start, that of the goal; or one alone
    std::vector<std::array<std::uint32_t, 2>> edges;  ///< of a roadmap: pairs of nodes
};

/// Which end of the problem is not valid and why: which requirement, which ASV, broom or obstacle,
/// by how much; empty when both are valid, or when no chain of so many ASVs could be.
std::vector<InvalidEnd> invalid_ends(const Problem& problem);

/// Plans, improves and checks. The same options with one thread and enough time give the same
/// solution, byte for byte, with the first path and with optimize == 0.
/// Throws std::invalid_argument when start or goal is not valid or an option makes no sense, and
/// std::logic_error when the validator rejects the path that was found (a bug).
SolveResult solve(const Problem& problem, const SolveOptions& options = {});

}  // namespace asv::core
