#include "core/validation/motion/quadratic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asv::core::validation {
namespace {

using geometry::Point;

constexpr double half_ulp = std::numeric_limits<double>::epsilon() / 2;
constexpr double error_of_product = 512 * half_ulp;

Point minus(const Point& a, const Point& b) {
    return {a.x - b.x, a.y - b.y};
}

double cross(const Point& a, const Point& b) {
    return a.x * b.y - a.y * b.x;
}

double largest_component(const Moving& vector) {
    return std::max({std::abs(vector.from.x), std::abs(vector.from.y), std::abs(vector.to.x),
                     std::abs(vector.to.y)});
}

Moving turned_left(const Moving& vector) {
    return {{-vector.from.y, vector.from.x}, {-vector.to.y, vector.to.x}};
}

}  // namespace

Point Moving::at(double t) const {
    return {std::lerp(from.x, to.x, t), std::lerp(from.y, to.y, t)};
}

Moving difference(const Moving& a, const Moving& b) {
    return {minus(b.from, a.from), minus(b.to, a.to)};
}

double Quadratic::place_of_least(double begin, double end) const {
    double place = at(begin) <= at(end) ? begin : end;
    if (square > 0) {
        const double vertex = std::clamp(-linear / (2 * square), begin, end);
        if (at(vertex) < at(place)) place = vertex;
    }
    return place;
}

double Quadratic::least(double begin, double end) const {
    return at(place_of_least(begin, end)) - error;
}

Quadratic operator+(const Quadratic& a, const Quadratic& b) {
    return {a.constant + b.constant, a.linear + b.linear, a.square + b.square, a.error + b.error};
}

Quadratic operator*(double factor, const Quadratic& a) {
    return {factor * a.constant, factor * a.linear, factor * a.square, std::abs(factor) * a.error};
}

Quadratic cross(const Moving& u, const Moving& v) {
    const Point du = minus(u.to, u.from);
    const Point dv = minus(v.to, v.from);
    return {cross(u.from, v.from), cross(u.from, dv) + cross(du, v.from), cross(du, dv),
            error_of_product * largest_component(u) * largest_component(v)};
}

Quadratic dot(const Moving& u, const Moving& v) {
    return cross(u, turned_left(v));
}

}  // namespace asv::core::validation
