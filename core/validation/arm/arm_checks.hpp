#pragma once

#include <span>
#include <vector>

#include "core/model/body.hpp"
#include "core/model/requirements.hpp"
#include "core/validation/finding.hpp"
#include "core/validation/state_checks.hpp"

/// The requirements on an arm, which is given by the positions of its base, joints and tip.
/// Precondition of all: one position more than the arm has links, finite coordinates.

namespace asv::core::validation {

/// Reads joint angles back from positions. Angles a full turn apart look the same; each is taken to
/// be the one nearest to that of the state before, which is right as long as no link turns by half
/// a turn in one step.
class JointReader {
  public:
    /// reference: the angles that those of the first state are nearest to.
    JointReader(const PlanarArm& arm, std::vector<double> reference);

    /// The angles of the next state, radians.
    const std::vector<double>& read(State state);

  private:
    const PlanarArm& arm_;
    std::vector<double> angles_;
};

/// The middle of each joint's range: what a state without a past is read by.
std::vector<double> middle_of_ranges(const PlanarArm& arm);

/// Each link has its length within the tolerance. Room: length.
Finding check_link_lengths(State state, const PlanarArm& arm, const Requirements& requirements);

/// The base is within the tolerance of where it is fixed. Room: length.
Finding check_base(State state, const geometry::Point& base, const Requirements& requirements);

/// Each joint that does not wrap is within its range, widened by the tolerance. Room: radians.
Finding check_joint_limits(std::span<const double> angles, const PlanarArm& arm,
                           const Requirements& requirements);

/// No joint that does not wrap ends full turns away from where it should. Room: radians, infinite
/// where it does not.
Finding check_turns(std::span<const double> angles, std::span<const double> wanted,
                    const PlanarArm& arm);

/// The Euclidean length of the way between two rows of joint angles.
double joint_distance(std::span<const double> from, std::span<const double> to);

}  // namespace asv::core::validation
