#pragma once

#include <cstdint>
#include <random>

#include "geometry/primitives.hpp"

namespace asv::geometry {

/// The number of cases of a randomised test: as asked, times the environment variable
/// ASV_TEST_SCALE (a sanitizer build sets it below 1), at least 1.
std::size_t test_count(std::size_t asked);

/// Draws inputs on which rounding decides. The same seed draws the same inputs on every platform.
class Adversary {
  public:
    explicit Adversary(std::uint64_t seed) : engine_(seed) {}

    struct Pair {
        Segment segment;
        Box box;
    };
    /// A segment and a box that is not empty: random, touching in a corner or a side, collinear
    /// with a side, one ulp away from any of these, degenerate to a point or a line, and all of it
    /// scaled by powers of two down to subnormal and up to nearly infinite numbers.
    Pair pair();

    struct Triple {
        Point a, b, c;
    };
    /// Three points that are often collinear or nearly so, scaled likewise.
    Triple triple();

    double uniform(double low, double high);
    /// Uniform among 0 .. count - 1.
    int pick(int count);

    /// The point, each coordinate as it is or one ulp off.
    Point nudged(const Point& point);

  private:
    Pair plain_pair();
    Pair lattice_pair();
    Pair corner_pair();
    Pair side_pair();
    double nudged(double value);
    double scale();

    std::mt19937_64 engine_;
};

}  // namespace asv::geometry
