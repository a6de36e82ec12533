#pragma once

#include <span>
#include <vector>

#include "core/chain/chain.hpp"
#include "core/model/problem.hpp"
#include "core/space/proof/kept_obstacles.hpp"

namespace asv::core {

/// The requirements as the planner keeps them: a little stricter than the assignment (a margin),
/// but never stricter than what the start and the goal themselves meet, so that both belong to the
/// valid set and can be left. For counter-clockwise chains; clockwise problems are transposed
/// first. In the words of the checker (Check): the broom lengths hold by themselves; convexity asks
/// for the turns and the closing turns; area, bounds and collisions (obstacles) are called the
/// same.
struct ChainConstraints {
    /// Is anything asked of the turns, the area and the closing side? Of ASVs alone; without it the
    /// numbers for these mean nothing.
    bool shaped = true;
    double extent = 1;           ///< the size of coordinates, which rounding is in proportion to
    std::vector<Box> obstacles;  ///< grown by their own margin each
    Box bounds;                  ///< where every ASV has to be
    double min_area = 0;         ///< of the closed polygon
    double min_last_closing_turn = 0;  ///< of cross(broom n-1, closing side): sine times its length
    double min_first_closing_turn = 0;  ///< of cross(closing side, broom 1): sine times its length
    double min_closing_side = 0;   ///< length of the closing side; its direction is singular at 0
    std::vector<double> min_turn;  ///< of each intermediate turn; 0 but for rounding
    double max_turn = 0;           ///< of an intermediate turn
};

/// How far the planner keeps from the limits where start and goal allow it.
struct Margins {
    double length = 1e-5;         ///< to obstacles, bounds and straight closing turns: more than a
                                  ///< step's chord cuts off
    double relative_area = 1e-6;  ///< of the minimum area
    double closing_side = 0.004;  ///< least closing side; a shorter one made the only invalid paths
    double slack = 1e-11;  ///< room that start and goal get: above rounding, below any tolerance
};

/// prepared: the problem's obstacles grown by margins.length, which spares looking at those that
/// are far from both ends; the constraints are the same without them.
/// Precondition: start and goal of the problem are valid and counter-clockwise.
ChainConstraints make_constraints(const Problem& problem, const Chain& chain,
                                  const Margins& margins = {},
                                  const KeptObstacles* prepared = nullptr);

/// The same for the chain of an arm or a point, of which only obstacles and bounds ask something.
/// Precondition: start and goal of the problem are valid, its bounds finite.
ChainConstraints make_joint_constraints(const Problem& problem, const Chain& chain,
                                        const Margins& margins = {},
                                        const KeptObstacles* prepared = nullptr);

/// The shoelace area of the closed polygon, positive when counter-clockwise.
double area(const Pose& pose);
/// |closing side| times the sine of the turn from broom n-1 into the closing side.
double last_closing_turn(const Pose& pose);
/// |closing side| times the sine of the turn from the closing side into broom 1.
double first_closing_turn(const Pose& pose);
/// Length of the side from ASV n to ASV 1.
double closing_side(const Pose& pose);

}  // namespace asv::core
