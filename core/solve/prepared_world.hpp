#pragma once

#include <memory>

#include "core/model/placement.hpp"
#include "core/model/problem.hpp"
#include "core/solve/solve.hpp"
#include "core/solve/solve_result.hpp"

namespace asv::core {

class PlanningObstacles;

/// From where to where in a prepared world. An end that is left empty is that of the world's
/// problem. Of an arm only the angles are read, its points follow from them.
struct WorldQuery {
    Placement start, goal;
};

/// A body, its requirements and its obstacles, made ready for query after query: what planning
/// builds of the obstacles alone is built once. It pays where they are many and paths are short;
/// among few there is next to nothing to build (docs/library.md has figures).
///
/// Immutable: several threads may ask at once, and no query leaves anything behind. Takes about a
/// kilobyte for each obstacle, and as much again once chains of both orientations have been planned
/// for.
class PreparedWorld {
  public:
    /// Keeps the problem; its start and goal, which need not be valid, tell how many points the
    /// body has. O(m log m) for m obstacles. Throws std::invalid_argument where start or goal have
    /// no point, or not as many as the other.
    explicit PreparedWorld(Problem problem);
    PreparedWorld(PreparedWorld&&) noexcept;
    PreparedWorld& operator=(PreparedWorld&&) noexcept;
    ~PreparedWorld();

    /// As it was given.
    const Problem& problem() const { return problem_; }

    /// The problem that a query asks. Throws std::invalid_argument where an end has not as many
    /// points, or angles of an arm, as the world's body, or an angle is out of its joint's range.
    Problem problem_of(const WorldQuery& query) const;

    /// What solve(problem_of(query), options) gives, byte for byte with one thread and enough time,
    /// and throws. The time limit counts from the call.
    SolveResult solve(const WorldQuery& query = {}, const SolveOptions& options = {}) const;

  private:
    Problem problem_;
    std::unique_ptr<const PlanningObstacles> obstacles_;
};

}  // namespace asv::core
