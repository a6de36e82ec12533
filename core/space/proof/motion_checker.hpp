#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/chain/chain.hpp"
#include "core/space/proof/chain_constraints.hpp"
#include "core/space/proof/line_motion.hpp"
#include "core/space/proof/obstacle_field.hpp"
#include "core/space/proof/proven_stretch.hpp"

namespace asv::core {

/// Proves straight lines in C-space valid: adaptive dynamic collision checking (Schwarzer, Saha and
/// Latombe, 2005) with clearance bounds below against displacement bounds above.
///
/// Along a straight line every heading is linear in the parameter t in [0, 1]. A constraint g(t) >=
/// 0 with value g and slope g' at one moment and |g''| <= c everywhere holds at least while g + g'
/// s - c s^2 / 2 >= 0. For a broom and a box g is the gap along one fixed separating axis, so that
/// sliding along a wall costs next to nothing. What is settled at no resolution counts as blocked.
///
/// Holds scratch memory: one checker for each thread; nothing is allocated after the first calls.
class MotionChecker {
  public:
    MotionChecker(const Chain& chain, const ChainConstraints& constraints,
                  const ObstacleField& field);

    const Chain& chain() const { return chain_; }
    const ChainConstraints& constraints() const { return constraints_; }
    const ObstacleField& field() const { return field_; }

    /// Is the single configuration valid?
    bool valid(std::span<const double> row);

    /// Is every configuration on the line valid?
    bool valid(std::span<const double> from, std::span<const double> to);

    /// A parameter up to which the line is proven valid: 1 when all of it is, less than 0 when not
    /// even its start is. It stops short of the first blocked one by at most the resolution.
    /// Precondition: resolution > 0, in units of length.
    double valid_prefix(std::span<const double> from, std::span<const double> to,
                        double resolution);

    /// How far any point of the chain moved at most along the line that was looked at last.
    double speed_bound() const { return motion_.speed_bound(); }

    std::uint64_t state_checks() const { return state_checks_; }
    std::uint64_t motion_checks() const { return motion_checks_; }

  private:
    struct Gap {
        double begin, end;
    };

    double prove(std::span<const double> from, std::span<const double> to, double resolution,
                 bool only_yes);
    /// What is proven around a moment of the line, at most so far back and ahead.
    ProvenStretch prove_around(double t, double back, double ahead);

    const Chain& chain_;
    const ChainConstraints& constraints_;
    const ObstacleField& field_;
    double rounding_, finest_motion_;

    LineMotion motion_;
    std::vector<Gap> gaps_;
    std::uint64_t state_checks_ = 0, motion_checks_ = 0;
};

}  // namespace asv::core
