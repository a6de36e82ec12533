#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <vector>

#include "core/model/problem.hpp"
#include "core/solve/planning_frame.hpp"
#include "core/solve/solve.hpp"
#include "core/space/proof/kept_obstacles.hpp"

namespace asv::core {

/// The obstacles that many problems have in common, in planning coordinates: as those of chains
/// that turn counter-clockwise and, transposed, of the others. Each is made when it is first asked
/// for; may be asked by several threads at once.
class PlanningObstacles {
  public:
    /// Precondition: always the frame of one of these problems, which differ in start and goal
    /// alone.
    std::shared_ptr<const KeptObstacles> in(const PlanningFrame& frame) const;

    /// What invalid_ends() finds. Where both ends are valid it looks only at obstacles near them.
    /// Precondition: the frame is that of the problem, but for valid ends.
    std::vector<InvalidEnd> find_invalid_ends(const Problem& problem,
                                              const PlanningFrame& frame) const;

  private:
    struct Seen {
        std::once_flag made;
        std::shared_ptr<const KeptObstacles> obstacles;
    };
    mutable std::array<Seen, 2> seen_;  ///< as they are, and transposed
};

/// solve() or, with a last path, replan(), with what was prepared of the problem's obstacles.
SolveResult solve_among(const PlanningObstacles* prepared, const Path* last, const Problem& problem,
                        const SolveOptions& options);

}  // namespace asv::core
