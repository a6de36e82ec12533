#include "core/shapes/chain_shapes.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "core/model/problem.hpp"
#include "core/shapes/flat_chain.hpp"
#include "core/validation/validate.hpp"
#include "geometry/elementary/functions.hpp"

namespace asv::core {

namespace {

/// Above the least area, as a share of it: far more than what rounding takes away, and what the
/// generator leaves by default.
constexpr double area_margin = 0.02;

/// A line is at least so high, as a share of a broom, where next to no area is asked for: it turns
/// at its ends by clearly less than pi.
constexpr double least_height = 0.01;

/// Throws std::invalid_argument that says which requirement on its shape the chain violates.
std::vector<Point> checked(std::vector<Point> chain, const Requirements& requirements) {
    Problem alone{chain, chain, {}, requirements};
    alone.requirements.bounds = without_bounds();
    const ValidationReport report =
        validate_state(alone, chain, {.tolerance = requirements.tolerance});
    for (const CheckResult& check : report.checks)
        if (!check.ok()) throw std::invalid_argument(describe(check));
    return chain;
}

/// The chain with these turns to the left, the first broom so much to the left of the heading; or
/// its mirror image. Turns of one ASV do not matter.
std::vector<Point> placed(std::vector<double> turns, double left, const Requirements& requirements,
                          const ShapePlace& place) {
    if (place.clockwise)
        for (double& turn : turns) turn = -turn;
    const double heading = place.heading + (place.clockwise ? -left : left);
    return checked(chain_positions(turns, heading, place.first, requirements.broom_length),
                   requirements);
}

/// One ASV has any shape, two have none. What is left has at least one turn.
bool is_alone(std::size_t asv_count) {
    if (asv_count == 0 || asv_count == 2)
        throw std::invalid_argument(std::to_string(asv_count) + " ASVs enclose no area");
    return asv_count == 1;
}

}  // namespace

std::vector<Point> chain_positions(std::span<const double> turns, double heading,
                                   const Point& first, double broom_length) {
    std::vector<Point> points{first};
    points.reserve(turns.size() + 2);
    for (std::size_t i = 0; i <= turns.size(); ++i) {
        if (i > 0) heading += turns[i - 1];
        points.push_back({points.back().x + broom_length * elementary::cos(heading),
                          points.back().y + broom_length * elementary::sin(heading)});
    }
    return points;
}

std::vector<Point> line_chain(std::size_t asv_count, const Requirements& requirements,
                              const ShapePlace& place) {
    if (is_alone(asv_count)) return {place.first};
    Requirements roomy = requirements;
    roomy.area_radius_per_broom *= std::sqrt(1 + area_margin);
    const double broom = requirements.broom_length;
    const double height = std::max(min_flat_height(asv_count, roomy), least_height * broom);
    // A flat chain rises from its closing side, to the left of the way to ASV n, and then turns to
    // the right; one that turns to the left lies on the right.
    return placed(flat_chain_turns(asv_count, broom, height),
                  -flat_chain_heading(asv_count, broom, height), requirements, place);
}

std::vector<Point> arc_chain(std::size_t asv_count, const Requirements& requirements,
                             const ShapePlace& place, double bend) {
    if (is_alone(asv_count)) return {place.first};
    const std::size_t count = asv_count - 2;
    const std::vector<double> turns(count, bend / static_cast<double>(count));
    return placed(turns, -bend / 2, requirements, place);
}

std::vector<Point> hook_chain(std::size_t asv_count, const Requirements& requirements,
                              const ShapePlace& place, double bend,
                              std::optional<std::size_t> leg) {
    if (is_alone(asv_count)) return {place.first};
    const std::size_t brooms = asv_count - 1;
    const std::size_t straight = leg.value_or((brooms + 1) / 2);
    if (straight < 1 || straight >= brooms)
        throw std::invalid_argument("a leg of " + std::to_string(straight) + " of " +
                                    std::to_string(brooms) + " brooms leaves none on one side");
    const std::size_t bent = brooms - straight;
    std::vector<double> turns(brooms - 1, 0.0);
    for (std::size_t i = straight - 1; i < turns.size(); ++i)
        turns[i] = bend / static_cast<double>(bent);
    return placed(turns, 0, requirements, place);
}

}  // namespace asv::core
