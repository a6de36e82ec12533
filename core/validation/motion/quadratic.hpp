#pragma once

#include "geometry/primitives.hpp"

/// What a straight motion between two states makes of positions, products and areas: polynomials
/// of the time t in [0, 1] of degree one and two, with a bound on what rounding did to them.

namespace asv::core::validation {

/// A point, or the difference of two points, that moves from one place to another.
struct Moving {
    geometry::Point from;
    geometry::Point to;

    geometry::Point at(double t) const;
};

/// The vector from a to b.
Moving difference(const Moving& a, const Moving& b);

/// constant + linear * t + square * t^2, which differs by at most error from the true value
/// anywhere in [0, 1].
struct Quadratic {
    double constant = 0;
    double linear = 0;
    double square = 0;
    double error = 0;

    double at(double t) const { return constant + t * (linear + t * square); }

    /// Where in [begin, end] the computed polynomial is least.
    double place_of_least(double begin, double end) const;

    /// A true lower bound over [begin, end]: the least value minus the error.
    double least(double begin, double end) const;
};

Quadratic operator+(const Quadratic& a, const Quadratic& b);
Quadratic operator*(double factor, const Quadratic& a);

/// u.x * v.y - u.y * v.x and u.x * v.x + u.y * v.y over time.
///
/// Precondition: both come from difference(), so that each component carries at most one rounding.
/// With h = 2^-53, U and V the largest components, the coefficients consist of two, four and two
/// products whose factors are at most U or 2U, V or 2V in size and wrong by at most h U or 4h U,
/// h V or 4h V. That makes them wrong by less than 8, 56 and 48 times h U V, and evaluating them,
/// where no intermediate value exceeds 18 U V, adds less than 72 h U V: together below 184 h U V.
/// The error given is 512 h U V; the rest covers scaling by at most 1 and adding two of them.
Quadratic cross(const Moving& u, const Moving& v);
Quadratic dot(const Moving& u, const Moving& v);

}  // namespace asv::core::validation
