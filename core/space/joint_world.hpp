#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "core/chain/chain.hpp"
#include "core/model/path.hpp"
#include "core/model/placement.hpp"
#include "core/model/problem.hpp"
#include "core/search/search_result.hpp"
#include "core/space/proof/chain_constraints.hpp"
#include "core/space/proof/kept_obstacles.hpp"
#include "core/space/proof/motion_checker.hpp"
#include "core/space/proof/obstacle_field.hpp"

namespace asv::core {

/// One coordinate of the C-space of an arm or a point.
struct JointCoordinate {
    std::size_t joint = 0;  ///< of the arm; 0 and 1 are x and y of a point
    double low = 0, high = 0;
    bool wraps = false;
};

/// The problem of an arm or a point made ready for planning: immutable, shared by all threads.
/// A configuration is the row of its joint angles (those that wrap first, else in order), or x, y.
class JointWorld {
  public:
    /// prepared: the problem's obstacles, where they are at hand; the world is the same without.
    /// Precondition: the body is no chain of ASVs; start and goal of the problem are valid, its
    /// bounds are finite.
    explicit JointWorld(const Problem& given,
                        const std::shared_ptr<const KeptObstacles>& prepared = nullptr);
    JointWorld(const JointWorld&) = delete;
    JointWorld& operator=(const JointWorld&) = delete;

    std::size_t dimension() const { return coordinates.size(); }
    std::size_t wrapping_count() const;
    MotionChecker make_checker() const { return {chain, constraints, field}; }

    /// The chain's configuration; linear. Precondition: out has chain.dimension() numbers.
    void chain_row(std::span<const double> row, std::span<double> out) const;
    /// A whole path likewise.
    Configurations chain_rows(const Configurations& rows) const;
    /// Where the body is.
    Placement placement(std::span<const double> row) const;
    /// The configurations of states, each by full turns of its angles the nearest to the one before
    /// it, the first to the start. Precondition: states of the problem's body.
    Configurations rows_of(const Path& path) const;
    /// Is every coordinate that does not wrap within its limits?
    bool within_limits(std::span<const double> row) const;

    Problem problem;
    std::vector<JointCoordinate> coordinates;
    Chain chain;
    ChainConstraints constraints;
    std::shared_ptr<const ObstacleField> shared_field;  ///< with other worlds
    const ObstacleField& field;
    std::vector<double> start, goal;  ///< configurations

  private:
    /// Those of a configuration, by joints.
    std::vector<double> values_in_order(std::span<const double> row) const;
};

}  // namespace asv::core
