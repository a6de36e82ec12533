#pragma once

#include <vector>

#include "asv/core/chain/chain.hpp"
#include "asv/core/problem.hpp"
#include "asv/core/space/chain_constraints.hpp"
#include "asv/core/space/metric.hpp"
#include "asv/core/space/motion.hpp"
#include "asv/core/space/obstacle_field.hpp"

namespace asv::core {

/// A problem made ready for planning: immutable, shared by all threads. Chains that turn clockwise
/// are planned for in the plane with x and y swapped, where they turn counter-clockwise.
struct BroomWorld {
    /// Precondition: start and goal of the problem are valid and of one orientation.
    BroomWorld(const Problem& given, Anchor anchor);
    BroomWorld(const BroomWorld&) = delete;
    BroomWorld& operator=(const BroomWorld&) = delete;

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
