#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/model/path.hpp"
#include "core/model/placement.hpp"
#include "core/solve/tree_picture.hpp"
#include "core/validation/report.hpp"

namespace asv::core {

enum class SolveStatus { solved, timeout, infeasible, interrupted };

/// "solved", "timeout", "infeasible", "interrupted".
std::string_view name(SolveStatus status);

struct SolveStatistics {
    double time_to_first = 0;     ///< seconds until there was a path
    double time_total = 0;        ///< seconds
    double cost_first = 0;        ///< of the first path, workspace units (an arm's in radians)
    double cost = 0;              ///< of the solution
    double cost_of_search = 0;    ///< of the path that the search ended with, before any shortcut
    double cost_lower_bound = 0;  ///< no path costs less; 0 where there was no time for it
    std::size_t steps_lower_bound = 0;  ///< no path has fewer primitive steps; 0 where not known
    /// The improvement had nothing left to gain: no path that keeps the planner's margins costs
    /// less than this one by more than a share of 1e-5. False where that is not known.
    bool optimal = false;
    std::size_t tree_nodes[2] = {0, 0};
    std::size_t iterations = 0;                       ///< of the search that found the path
    std::uint64_t state_checks = 0, edge_checks = 0;  ///< of all threads
    /// (seconds, cost) whenever a better path was found.
    std::vector<std::pair<double, double>> cost_history;
};

struct SolveResult {
    SolveStatus status = SolveStatus::timeout;
    std::string reason;                ///< why there is no solution; empty when solved
    std::optional<Solution> solution;  ///< passed the validator
    /// Where the path of the solution has its corners, start and goal included: some ten to a
    /// hundred placements between which it was cut into primitive steps. From one to the next the
    /// angles of an arm or the place of a point change evenly; of a chain the middle of its ASVs
    /// (of planner rrt-connect ASV 1), its heading and its turns. Steps may cut a corner.
    std::vector<Placement> corners;
    /// What the validator says of the solution: `checks` all hold; `motion` is there where
    /// SolveOptions::certify_motion asks for it, and may say that it is not certified.
    ValidationReport report;
    SolveStatistics statistics;
    std::vector<TreePicture> trees;  ///< that of the start, that of the goal; or one alone
    std::vector<std::array<std::uint32_t, 2>> edges;  ///< of a roadmap: pairs of nodes
};

}  // namespace asv::core
