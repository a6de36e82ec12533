#pragma once

#include <vector>

#include "core/chain/chain.hpp"
#include "core/model/problem.hpp"
#include "core/space/metric.hpp"
#include "core/space/proof/chain_constraints.hpp"
#include "core/space/proof/motion_checker.hpp"
#include "core/space/proof/obstacle_field.hpp"

namespace asv::core {

/// A problem made ready for planning: immutable, shared by all threads. Chains that turn clockwise
/// are planned for in the plane with x and y swapped, where they turn counter-clockwise.
struct ChainWorld {
    /// Precondition: start and goal of the problem are valid and of one orientation.
    ChainWorld(const Problem& given, Anchor anchor);
    ChainWorld(const ChainWorld&) = delete;
    ChainWorld& operator=(const ChainWorld&) = delete;

    MotionChecker make_checker() const { return {chain, constraints, field}; }

    bool transposed;
    Problem problem;  ///< counter-clockwise
    Chain chain;
    ChainConstraints constraints;
    ObstacleField field;
    Metric metric;
    std::vector<double> start, goal;  ///< configurations
};

/// The problem with x and y swapped everywhere, which mirrors orientations exactly.
Problem transposed(Problem problem);

}  // namespace asv::core
