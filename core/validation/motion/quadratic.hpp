#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/primitives.hpp"

/// What a straight motion between two states makes of positions, products and areas: polynomials
/// of the time t in [0, 1] of degree one and two, with a bound on what rounding did to them.

namespace asv::core::validation {

/// A point, or the difference of two points, that moves from one place to another.
struct Moving {
    geometry::Point from;
    geometry::Point to;

    geometry::Point at(double t) const {
        // As std::lerp does, but most of the times that are asked for are these two.
        if (t == 0) return from;
        if (t == 1) return to;
        return {std::lerp(from.x, to.x, t), std::lerp(from.y, to.y, t)};
    }
};

/// The vector from a to b.
inline Moving difference(const Moving& a, const Moving& b) {
    return {{b.from.x - a.from.x, b.from.y - a.from.y}, {b.to.x - a.to.x, b.to.y - a.to.y}};
}

/// constant + linear * t + square * t^2, which differs by at most error from the true value
/// anywhere in [0, 1].
struct Quadratic {
    double constant = 0;
    double linear = 0;
    double square = 0;
    double error = 0;

    double at(double t) const { return constant + t * (linear + t * square); }

    /// Where in [begin, end] the computed polynomial is least.
    double place_of_least(double begin, double end) const {
        double place = at(begin) <= at(end) ? begin : end;
        if (square > 0) {
            const double vertex = std::clamp(-linear / (2 * square), begin, end);
            if (at(vertex) < at(place)) place = vertex;
        }
        return place;
    }

    /// A true lower bound over [begin, end]: the least value minus the error.
    double least(double begin, double end) const { return at(place_of_least(begin, end)) - error; }
};

inline Quadratic operator+(const Quadratic& a, const Quadratic& b) {
    return {a.constant + b.constant, a.linear + b.linear, a.square + b.square, a.error + b.error};
}

inline Quadratic operator*(double factor, const Quadratic& a) {
    return {factor * a.constant, factor * a.linear, factor * a.square, std::abs(factor) * a.error};
}

/// u.x * v.y - u.y * v.x and u.x * v.x + u.y * v.y over time.
///
/// Precondition: both come from difference(), so that each component carries at most one rounding.
/// With h = 2^-53, U and V the largest components, the coefficients consist of two, four and two
/// products whose factors are at most U or 2U, V or 2V in size and wrong by at most h U or 4h U,
/// h V or 4h V. That makes them wrong by less than 8, 56 and 48 times h U V, and evaluating them,
/// where no intermediate value exceeds 18 U V, adds less than 72 h U V: together below 184 h U V.
/// The error given is 512 h U V; the rest covers scaling by at most 1 and adding two of them.
inline Quadratic cross(const Moving& u, const Moving& v) {
    constexpr double error_of_product = 512 * (std::numeric_limits<double>::epsilon() / 2);
    const auto largest = [](const Moving& w) {
        return std::max(
            {std::abs(w.from.x), std::abs(w.from.y), std::abs(w.to.x), std::abs(w.to.y)});
    };
    const auto product = [](const geometry::Point& a, const geometry::Point& b) {
        return a.x * b.y - a.y * b.x;
    };
    const geometry::Point du{u.to.x - u.from.x, u.to.y - u.from.y};
    const geometry::Point dv{v.to.x - v.from.x, v.to.y - v.from.y};
    return {product(u.from, v.from), product(u.from, dv) + product(du, v.from), product(du, dv),
            error_of_product * largest(u) * largest(v)};
}

inline Quadratic dot(const Moving& u, const Moving& v) {
    const Moving turned_left{{-v.from.y, v.from.x}, {-v.to.y, v.to.x}};
    return cross(u, turned_left);
}

}  // namespace asv::core::validation
