#include "core/space/proof/chain_constraints.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/elementary/functions.hpp"
#include "geometry/predicates/distance.hpp"

namespace asv::core {

using geometry::Segment;

double area(const Pose& pose) {
    double twice = 0;
    for (std::size_t i = 2; i < pose.x.size(); ++i)
        twice += (pose.x[i - 1] - pose.x[0]) * (pose.y[i] - pose.y[0]) -
                 (pose.x[i] - pose.x[0]) * (pose.y[i - 1] - pose.y[0]);
    return 0.5 * twice;
}

double last_closing_turn(const Pose& pose) {
    const double rx = pose.x.front() - pose.x.back(), ry = pose.y.front() - pose.y.back();
    return pose.ux.back() * ry - pose.uy.back() * rx;
}

double first_closing_turn(const Pose& pose) {
    const double rx = pose.x.front() - pose.x.back(), ry = pose.y.front() - pose.y.back();
    return rx * pose.uy.front() - ry * pose.ux.front();
}

double closing_side(const Pose& pose) {
    return elementary::hypot(pose.x.front() - pose.x.back(), pose.y.front() - pose.y.back());
}

namespace {

/// Distance from the chain to a box. Where there is one ASV, by how much the box may grow before it
/// meets it, which is less than the distance where a corner is the nearest.
double clearance(const Pose& pose, const Box& box) {
    if (pose.x.size() == 1) {
        const double x = pose.x[0], y = pose.y[0];
        return std::max(std::max(box.low.x - x, x - box.high.x),
                        std::max(box.low.y - y, y - box.high.y));
    }
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k + 1 < pose.x.size(); ++k)
        least = std::min(least,
                         geometry::distance(
                             Segment{{pose.x[k], pose.y[k]}, {pose.x[k + 1], pose.y[k + 1]}}, box));
    return least;
}

/// The limit with its margin, or what the tighter of the two ends leaves of it.
template <class Measure>
double kept(const std::vector<Pose>& ends, const Margins& margins, double limit, double margin,
            Measure&& measure) {
    const double room = std::min(measure(ends[0]), measure(ends[1])) - limit;
    return limit + std::min(margin, room - margins.slack);
}

std::vector<Pose> poses_of_ends(const Problem& problem, const Chain& chain) {
    std::vector<double> row(chain.dimension());
    std::vector<Pose> ends(2, chain.make_pose());
    for (std::size_t end = 0; end < 2; ++end) {
        chain.configuration(end == 0 ? problem.start : problem.goal, row);
        chain.forward(row, ends[end]);
    }
    return ends;
}

/// The obstacle with the margin that the ends leave it. Precondition: it has not vanished.
Box kept_obstacle(const Box& box, double e, const std::vector<Pose>& ends, const Margins& margins) {
    const auto to_box = [&](const Pose& pose) { return clearance(pose, box); };
    double margin = kept(ends, margins, 0, margins.length, to_box);
    if (margin < 0) {
        // An end that is inside the box by rounding is still outside the shrunk one.
        const Box shrunk = geometry::grown(box, -e);
        margin = kept(ends, margins, -e, e + margins.length,
                      [&](const Pose& pose) { return clearance(pose, shrunk) - e; });
    }
    return geometry::grown(box, margin);
}

std::vector<Box> kept_obstacles(const Problem& problem, const std::vector<Pose>& ends,
                                const Margins& margins) {
    const double e = problem.requirements.tolerance;
    std::vector<Box> boxes;
    for (const Box& box : problem.obstacles)
        if (!geometry::is_empty(geometry::grown(box, -e)))
            boxes.push_back(kept_obstacle(box, e, ends, margins));
    return boxes;
}

/// The same, when only those near the ends have to be looked at.
std::vector<Box> kept_obstacles(const Problem& problem, const std::vector<Pose>& ends,
                                const Margins& margins, const KeptObstacles& prepared) {
    // Farther from both ends an obstacle has its whole margin; twice that covers all rounding.
    const double near = 2 * (margins.length + margins.slack);
    const ObstacleField& field = prepared.field();
    std::vector<Box> boxes(field.boxes().begin(), field.boxes().end());
    const auto look = [&](std::size_t i, const Box& /*grown*/) {
        const Box& box = problem.obstacles[prepared.numbers()[i]];
        boxes[i] = kept_obstacle(box, problem.requirements.tolerance, ends, margins);
    };
    for (const Pose& pose : ends)
        for (std::size_t k = 0; k < pose.x.size(); ++k) {
            const std::size_t other = std::min(k + 1, pose.x.size() - 1);
            field.visit_within({{pose.x[k], pose.y[k]}, {pose.x[other], pose.y[other]}}, near,
                               look);
        }
    return boxes;
}

void keep_clear(const Problem& problem, const std::vector<Pose>& ends, const Margins& margins,
                const KeptObstacles* prepared, ChainConstraints& result) {
    result.obstacles = prepared ? kept_obstacles(problem, ends, margins, *prepared)
                                : kept_obstacles(problem, ends, margins);
    const Requirements& required = problem.requirements;
    const auto extreme = [](const std::vector<double>& values, double sign) {
        double least = std::numeric_limits<double>::infinity();
        for (double value : values) least = std::min(least, sign * value);
        return least;
    };
    const auto side = [&](double limit, auto&& measure) {
        return kept(ends, margins, limit, margins.length, measure);
    };
    const Box& b = required.bounds;
    result.bounds.low.x = side(b.low.x, [&](auto& p) { return extreme(p.x, 1); });
    result.bounds.low.y = side(b.low.y, [&](auto& p) { return extreme(p.y, 1); });
    result.bounds.high.x = -side(-b.high.x, [&](auto& p) { return extreme(p.x, -1); });
    result.bounds.high.y = -side(-b.high.y, [&](auto& p) { return extreme(p.y, -1); });
}

}  // namespace

ChainConstraints make_constraints(const Problem& problem, const Chain& chain,
                                  const Margins& margins, const KeptObstacles* prepared) {
    const std::vector<Pose> ends = poses_of_ends(problem, chain);
    ChainConstraints result;
    result.min_turn.assign(chain.turn_count(), 0.0);
    result.max_turn = std::numbers::pi - 1e-6;
    std::vector<double> row(chain.dimension());
    for (const auto* end : {&problem.start, &problem.goal}) {
        chain.configuration(*end, row);
        for (std::size_t i = 0; i < chain.turn_count(); ++i)
            result.min_turn[i] = std::min(result.min_turn[i], row[3 + i]);
    }
    keep_clear(problem, ends, margins, prepared, result);
    if (chain.asv_count() < 3) return result;

    const double min_area = problem.requirements.min_area(chain.asv_count());
    const auto at_least = [&](double limit, double margin, auto&& measure) {
        return kept(ends, margins, limit, margin, measure);
    };
    result.min_area = at_least(min_area, margins.relative_area * min_area, area);
    // The closing side may be short, so that what a step's chord cuts off would show as an angle.
    result.min_last_closing_turn = at_least(0, margins.length, last_closing_turn);
    result.min_first_closing_turn = at_least(0, margins.length, first_closing_turn);
    result.min_closing_side = at_least(0, margins.closing_side, closing_side);
    return result;
}

ChainConstraints make_joint_constraints(const Problem& problem, const Chain& chain,
                                        const Margins& margins, const KeptObstacles* prepared) {
    ChainConstraints result;
    result.shaped = false;
    const Box& b = problem.requirements.bounds;
    for (const double coordinate : {b.low.x, b.low.y, b.high.x, b.high.y})
        result.extent = std::max(result.extent, std::abs(coordinate));
    Margins scaled = margins;
    scaled.slack *= result.extent;
    keep_clear(problem, poses_of_ends(problem, chain), scaled, prepared, result);
    return result;
}

}  // namespace asv::core
