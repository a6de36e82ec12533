#pragma once

#include <memory>
#include <vector>

#include "core/chain/chain.hpp"
#include "core/model/problem.hpp"
#include "core/search/trees/nearest.hpp"
#include "core/space/metric.hpp"
#include "core/space/proof/chain_constraints.hpp"
#include "core/space/proof/kept_obstacles.hpp"
#include "core/space/proof/motion_checker.hpp"
#include "core/space/proof/obstacle_field.hpp"

namespace asv::core {

/// The problem of a chain of ASVs made ready for planning: immutable, shared by all threads.
struct ChainWorld {
    /// prepared: the problem's obstacles, where they are at hand; the world is the same without.
    /// Precondition: start and goal of the problem are valid and turn counter-clockwise; its bounds
    /// are finite.
    ChainWorld(const Problem& given, Anchor anchor,
               const std::shared_ptr<const KeptObstacles>& prepared = nullptr);
    ChainWorld(const ChainWorld&) = delete;
    ChainWorld& operator=(const ChainWorld&) = delete;

    MotionChecker make_checker() const { return {chain, constraints, field}; }
    /// The angles of a configuration that come round after a full turn: the heading, if there is
    /// one.
    WrappingAngles wrapping() const { return {2, chain.asv_count() < 2 ? 0U : 1U}; }

    Problem problem;
    Chain chain;
    ChainConstraints constraints;
    std::shared_ptr<const ObstacleField> shared_field;  ///< with other worlds
    const ObstacleField& field;
    Metric metric;
    std::vector<double> start, goal;  ///< configurations
};

}  // namespace asv::core
