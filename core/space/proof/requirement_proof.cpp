#include "core/space/proof/requirement_proof.hpp"

#include "geometry/elementary/functions.hpp"

namespace asv::core {

namespace {

double cross(double ax, double ay, double bx, double by) {
    return ax * by - ay * bx;
}

}  // namespace

bool prove_bounds(const LineMotion& motion, const ChainConstraints& constraints,
                  ProvenStretch& stretch) {
    const Box& b = constraints.bounds;
    const Pose& pose = motion.pose();
    for (std::size_t j = 0; j < motion.chain().asv_count(); ++j) {
        const double a = motion.acceleration_bound(j);
        const double vx = motion.velocity_x(j), vy = motion.velocity_y(j);
        if (!stretch.limit(pose.x[j] - b.low.x, vx, a) ||
            !stretch.limit(b.high.x - pose.x[j], -vx, a) ||
            !stretch.limit(pose.y[j] - b.low.y, vy, a) ||
            !stretch.limit(b.high.y - pose.y[j], -vy, a))
            return false;
    }
    return true;
}

bool prove_turns(const LineMotion& motion, const ChainConstraints& constraints, double rounding,
                 ProvenStretch& stretch) {
    for (std::size_t i = 0; i < motion.chain().turn_count(); ++i) {
        const double turn = motion.row()[3 + i], rate = motion.step()[3 + i];
        // Straight joints are common, and interpolating between them rounds.
        if (!stretch.limit(turn - constraints.min_turn[i] + rounding, rate, 0) ||
            !stretch.limit(constraints.max_turn - turn, -rate, 0))
            return false;
    }
    return true;
}

bool prove_closing_side(const LineMotion& motion, const ChainConstraints& constraints,
                        double rounding, ProvenStretch& stretch) {
    const std::size_t end = motion.chain().asv_count() - 1;
    const Pose& pose = motion.pose();
    const LineMotion::ShapeCurvature& curvature = motion.shape_curvature();
    const double rx = pose.x[0] - pose.x[end], ry = pose.y[0] - pose.y[end];
    const double rvx = motion.velocity_x(0) - motion.velocity_x(end);
    const double rvy = motion.velocity_y(0) - motion.velocity_y(end);
    const double first_ux = pose.ux.front(), first_uy = pose.uy.front();
    const double last_ux = pose.ux.back(), last_uy = pose.uy.back();
    const double first_rate = motion.heading_rate().front();
    const double last_rate = motion.heading_rate().back();

    const double first =
        cross(rx, ry, first_ux, first_uy) - constraints.min_first_closing_turn + rounding;
    const double first_slope =
        cross(rvx, rvy, first_ux, first_uy) + first_rate * cross(rx, ry, -first_uy, first_ux);
    if (!stretch.limit(first, first_slope, curvature.first_closing_turn)) return false;
    const double last =
        cross(last_ux, last_uy, rx, ry) - constraints.min_last_closing_turn + rounding;
    const double last_slope =
        cross(last_ux, last_uy, rvx, rvy) + last_rate * cross(-last_uy, last_ux, rx, ry);
    if (!stretch.limit(last, last_slope, curvature.last_closing_turn)) return false;

    const double length = elementary::hypot(rx, ry);
    const double slope = length > 0 ? (rx * rvx + ry * rvy) / length : 0;
    // A distance bends upwards where it bends by moving sideways, so only r'' can lower it.
    return stretch.limit(length - constraints.min_closing_side + rounding, slope,
                         curvature.closing_side);
}

bool prove_area(const LineMotion& motion, const ChainConstraints& constraints, double rounding,
                ProvenStretch& stretch) {
    const Pose& pose = motion.pose();
    const auto vx = [&](std::size_t j) { return motion.velocity_x(j) - motion.velocity_x(0); };
    const auto vy = [&](std::size_t j) { return motion.velocity_y(j) - motion.velocity_y(0); };
    double twice = 0, twice_slope = 0;
    for (std::size_t i = 2; i < motion.chain().asv_count(); ++i) {
        const double ax = pose.x[i - 1] - pose.x[0], ay = pose.y[i - 1] - pose.y[0];
        const double bx = pose.x[i] - pose.x[0], by = pose.y[i] - pose.y[0];
        twice += cross(ax, ay, bx, by);
        twice_slope += cross(vx(i - 1), vy(i - 1), bx, by) + cross(ax, ay, vx(i), vy(i));
    }
    return stretch.limit(0.5 * twice - constraints.min_area + rounding, 0.5 * twice_slope,
                         motion.shape_curvature().area);
}

}  // namespace asv::core
