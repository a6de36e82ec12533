#include "asv/core/space/chain_constraints.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "asv/geometry/distance.hpp"

namespace asv::core {

using geometry::Segment;

double area(const Pose& pose) {
    double twice = 0;
    for (std::size_t i = 2; i < pose.x.size(); ++i)
        twice += (pose.x[i - 1] - pose.x[0]) * (pose.y[i] - pose.y[0]) -
                 (pose.x[i] - pose.x[0]) * (pose.y[i - 1] - pose.y[0]);
    return 0.5 * twice;
}

double last_turn(const Pose& pose) {
    const double rx = pose.x.front() - pose.x.back(), ry = pose.y.front() - pose.y.back();
    return pose.ux.back() * ry - pose.uy.back() * rx;
}

double first_turn(const Pose& pose) {
    const double rx = pose.x.front() - pose.x.back(), ry = pose.y.front() - pose.y.back();
    return rx * pose.uy.front() - ry * pose.ux.front();
}

double closing_length(const Pose& pose) {
    return std::hypot(pose.x.front() - pose.x.back(), pose.y.front() - pose.y.back());
}

namespace {

/// Distance from the chain to a box; a point where there is one ASV.
double clearance(const Pose& pose, const Box& box) {
    if (pose.x.size() == 1) return geometry::distance(Point{pose.x[0], pose.y[0]}, box);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k + 1 < pose.x.size(); ++k)
        least = std::min(least,
                         geometry::distance(
                             Segment{{pose.x[k], pose.y[k]}, {pose.x[k + 1], pose.y[k + 1]}}, box));
    return least;
}

}  // namespace

ChainConstraints make_constraints(const Problem& problem, const Chain& chain,
                                  const Margins& margins) {
    const Requirements& required = problem.requirements;
    std::vector<double> row(chain.dimension());
    std::vector<Pose> ends(2, chain.make_pose());
    ChainConstraints result;
    result.minimum_turn.assign(chain.turn_count(), 0.0);
    result.maximum_turn = std::numbers::pi - 1e-6;
    for (std::size_t end = 0; end < 2; ++end) {
        chain.configuration(end == 0 ? problem.start : problem.goal, row);
        chain.forward(row, ends[end]);
        for (std::size_t i = 0; i < chain.turn_count(); ++i)
            result.minimum_turn[i] = std::min(result.minimum_turn[i], row[3 + i]);
    }
    // The limit with its margin, or what the tighter of the two ends leaves of it.
    const auto kept = [&](double limit, double margin, auto&& measure) {
        const double room = std::min(measure(ends[0]), measure(ends[1])) - limit;
        return limit + std::min(margin, room - margins.slack);
    };

    const double e = required.tolerance;
    for (const Box& box : problem.obstacles) {
        const Box shrunk = geometry::grown(box, -e);
        if (geometry::is_empty(shrunk)) continue;
        const auto to_box = [&](const Pose& pose) { return clearance(pose, box); };
        double margin = kept(0, margins.length, to_box);
        // An end that is inside the box by rounding is still outside the shrunk one.
        if (margin < 0)
            margin = kept(-e, e + margins.length,
                          [&](const Pose& pose) { return clearance(pose, shrunk) - e; });
        result.boxes.push_back(geometry::grown(box, margin));
    }

    const auto extreme = [](const std::vector<double>& values, double sign) {
        double least = std::numeric_limits<double>::infinity();
        for (double value : values) least = std::min(least, sign * value);
        return least;
    };
    const Box& b = required.bounds;
    result.bounds.low.x = kept(b.low.x, margins.length, [&](auto& p) { return extreme(p.x, 1); });
    result.bounds.low.y = kept(b.low.y, margins.length, [&](auto& p) { return extreme(p.y, 1); });
    result.bounds.high.x =
        -kept(-b.high.x, margins.length, [&](auto& p) { return extreme(p.x, -1); });
    result.bounds.high.y =
        -kept(-b.high.y, margins.length, [&](auto& p) { return extreme(p.y, -1); });
    if (chain.asv_count() < 3) return result;

    const double least_area = required.minimum_area(chain.asv_count());
    result.minimum_area = kept(least_area, margins.relative_area * least_area, area);
    result.minimum_last_turn = kept(0, 0, last_turn);
    result.minimum_first_turn = kept(0, 0, first_turn);
    result.minimum_closing = kept(0, margins.closing, closing_length);
    return result;
}

}  // namespace asv::core
