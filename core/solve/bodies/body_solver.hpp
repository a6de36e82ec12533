#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/model/path.hpp"
#include "core/model/placement.hpp"
#include "core/model/problem.hpp"
#include "core/search/limits.hpp"
#include "core/search/rng.hpp"
#include "core/search/search_result.hpp"
#include "core/shorten/improve.hpp"
#include "core/solve/planner_catalogue.hpp"
#include "core/space/proof/kept_obstacles.hpp"

namespace asv::core {

/// What was looked at on the way.
struct ChecksSpent {
    std::uint64_t state_checks = 0, edge_checks = 0;

    ChecksSpent& operator+=(const ChecksSpent& more) {
        state_checks += more.state_checks;
        edge_checks += more.edge_checks;
        return *this;
    }
};

/// What a search found and what it took.
struct Attempt {
    SearchResult search;
    ChecksSpent checks;
    std::uint64_t constrained_steps = 0;  ///< of slides
};

/// An improved path and what it took.
struct Improved {
    Configurations path;
    ChecksSpent checks;
    bool optimal = false;  ///< nothing was left to gain
};

/// How long and whereto a path is to be improved.
struct ImprovementOrder {
    double work = 0;           ///< microseconds of a 2.8 GHz core, counted; see ImproveOptions
    bool other_paths = false;  ///< may search for other paths as well
    Limits limits;             ///< of everything
    /// Of the search for each other path; its iterations may grow, see PathFinder.
    Limits search_limits;
    CostObserver on_better = {};  ///< is told the cost of each better path
};

/// The stages of solving that depend on the body: its space, its searches, its improvement, its
/// primitive steps, all in the coordinates of the problem that it is made for. Immutable once made,
/// shared by all threads.
class BodySolver {
  public:
    virtual ~BodySolver() = default;

    /// Racers are numbered from 0, which plans as the settings say; others may vary them.
    virtual Attempt search(const Limits& limits, Rng& rng, const Observer& observer,
                           std::size_t racer) const = 0;

    /// A path from start to goal made of what is still valid of another one, in planning
    /// coordinates; see PathMender.
    virtual Attempt mend(const Path& last, const Limits& limits, Rng& rng) const = 0;

    /// The cost of a path of configurations; that of its steps may differ by some 0.1 %.
    virtual double cost(const Configurations& path) const = 0;

    /// A path that costs no more.
    virtual Improved improve(const Configurations& path, const ImprovementOrder& order,
                             Rng& rng) const = 0;

    /// The path in primitive steps; none when the deadline comes first.
    virtual std::optional<Path> steps(const Configurations& path,
                                      Clock::time_point deadline) const = 0;

    /// Where the body is at each configuration of a path, its ends as the problem has them.
    virtual std::vector<Placement> placements(const Configurations& path) const = 0;

    /// Where the body is to be seen at each node of a tree: ASV 1, the tip of an arm, the point.
    virtual std::vector<Point> places(const Tree& tree) const = 0;
};

/// The solver for the body of a problem in planning coordinates (see PlanningFrame), whose ends are
/// valid. Keeps references to both. prepared: the problem's obstacles, where they are at hand.
std::unique_ptr<BodySolver> make_body_solver(
    const Problem& problem, const Planner& planner,
    const std::shared_ptr<const KeptObstacles>& prepared = nullptr);

/// The two makers behind it: for a chain of ASVs, and for an arm or a point.
std::unique_ptr<BodySolver> make_chain_solver(const Problem& problem, const Planner& planner,
                                              const std::shared_ptr<const KeptObstacles>& prepared);
std::unique_ptr<BodySolver> make_joint_solver(const Problem& problem, const Planner& planner,
                                              const std::shared_ptr<const KeptObstacles>& prepared);

}  // namespace asv::core
