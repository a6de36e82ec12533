#pragma once

#include "geometry/primitives.hpp"
#include "tests/kit/random.hpp"

namespace asv::test {

/// Draws inputs on which rounding decides. The same seed draws the same inputs on every platform.
class Adversary : public Random {
  public:
    using Random::Random;

    struct Pair {
        geometry::Segment segment;
        geometry::Box box;
    };
    /// A segment and a box that is not empty: random, touching in a corner or a side, collinear
    /// with a side, one ulp away from any of these, degenerate to a point or a line, and all of it
    /// scaled by powers of two down to subnormal and up to nearly infinite numbers.
    Pair pair();

    struct Triple {
        geometry::Point a, b, c;
    };
    /// Three points that are often collinear or nearly so, scaled likewise.
    Triple triple();

    /// The point, each coordinate as it is or one ulp off.
    geometry::Point nudged(const geometry::Point& point);

  private:
    Pair plain_pair();
    Pair lattice_pair();
    Pair corner_pair();
    Pair side_pair();
    double nudged(double value);
    double scale();
};

}  // namespace asv::test
