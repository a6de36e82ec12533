#include "core/certificate_check/limits.hpp"

#include <algorithm>
#include <cmath>

namespace asv::core::certificate_check {

namespace {

/// The greatest coordinate that an ASV may have, or that start, goal and obstacles have where there
/// is no end to where it may be.
double largest_coordinate(const Problem& problem) {
    double largest = 0;
    const auto include = [&](const Point& point) {
        largest = std::max({largest, std::abs(point.x), std::abs(point.y)});
    };
    if (problem.requirements.bounded()) {
        include(problem.requirements.bounds.low);
        include(problem.requirements.bounds.high);
        return largest;
    }
    for (const auto* state : {&problem.start, &problem.goal})
        for (const Point& point : *state) include(point);
    for (const Box& box : problem.obstacles) {
        include(box.low);
        include(box.high);
    }
    return largest;
}

}  // namespace

Limits limits_of(const Problem& problem) {
    // Of a length or a coordinate, and of an area that is a sum of products of coordinates.
    constexpr double rounding = 0x1p-50, rounding_of_areas = 0x1p-45;
    const Requirements& r = problem.requirements;
    const Number largest = exact(largest_coordinate(problem));
    const Number brooms = exact(static_cast<double>(problem.asv_count()) - 1);
    Limits limits;
    limits.asv_count = problem.asv_count();
    limits.tolerance = exact(r.tolerance) + exact(rounding) * largest;
    limits.step = exact(r.max_step) + limits.tolerance;
    limits.broom = exact(r.broom_length) + limits.tolerance;
    limits.chain = brooms * limits.broom;
    const Number radius = brooms * exact(r.area_radius_per_broom);
    limits.required_area = pi_below() * radius * radius - exact(r.tolerance) -
                           exact(rounding_of_areas) * largest * largest;
    limits.shrink = limits.tolerance + limits.step / 2;
    return limits;
}

}  // namespace asv::core::certificate_check
