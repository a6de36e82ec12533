#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/search/rng.hpp"
#include "core/space/proof/motion_checker.hpp"
#include "geometry/primitives.hpp"

namespace asv::core {

/// Draws valid configurations dimension by dimension: a free position first, then one heading after
/// the other, each kept only if the chain so far is inside the bounds, free and turns one way.
/// Drawn whole, a sample is valid a few times in a million; drawn so, one time in ten.
class StepwiseSampler {
  public:
    /// Which end of the chain is placed first.
    enum class From { first_asv, last_asv };

    /// sharpest_turn: turns are drawn from [0, sharpest_turn], radians.
    StepwiseSampler(MotionChecker& checker, double sharpest_turn);

    /// Fills row with a valid configuration, its end at the given place or anywhere; false when
    /// the place is not free or a bounded number of tries found none.
    bool sample(Rng& rng, From from, std::optional<geometry::Point> place, bool any_turn,
                std::span<double> row);

  private:
    bool grow(Rng& rng, double sign, double sharpest);
    bool free(const geometry::Point& a, const geometry::Point& b);

    MotionChecker& checker_;
    double sharpest_turn_;
    std::vector<geometry::Point> positions_;
};

}  // namespace asv::core
