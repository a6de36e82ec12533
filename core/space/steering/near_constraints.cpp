#include "core/space/steering/near_constraints.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/elementary/functions.hpp"

namespace asv::core {

using Kind = NearConstraint::Kind;

NearConstraints::NearConstraints(const Chain& chain, const ChainConstraints& constraints,
                                 const ObstacleField& field)
    : chain_(chain), constraints_(constraints), field_(field) {}

std::span<const NearConstraint> NearConstraints::find(const Pose& pose, double radius) {
    near_.clear();
    for (std::size_t i = 0; i < chain_.turn_count(); ++i)
        near_.push_back({.kind = Kind::turn, .index = i});
    near_boxes(pose, radius);
    near_bounds(pose, radius);
    if (chain_.asv_count() >= 3)
        for (const Kind kind :
             {Kind::first_closing_turn, Kind::last_closing_turn, Kind::area, Kind::closing_side})
            near_.push_back({.kind = kind});
    return near_;
}

double NearConstraints::gap(const NearConstraint& near, std::span<const double> row,
                            const Pose& pose) const {
    const std::size_t k = near.index;
    switch (near.kind) {
        case Kind::turn:
            return row[3 + k] - constraints_.min_turn[k];
        case Kind::point: {
            const std::size_t asv = near.fraction > 0 ? k + 1 : k;
            return near.nx * pose.x[asv] + near.ny * pose.y[asv] - near.offset;
        }
        case Kind::corner:
            return near.offset *
                   (pose.ux[k] * (near.ny - pose.y[k]) - pose.uy[k] * (near.nx - pose.x[k]));
        case Kind::first_closing_turn:
            return first_closing_turn(pose) - constraints_.min_first_closing_turn;
        case Kind::last_closing_turn:
            return last_closing_turn(pose) - constraints_.min_last_closing_turn;
        case Kind::area:
            return area(pose) - constraints_.min_area;
        case Kind::closing_side:
            return closing_side(pose) - constraints_.min_closing_side;
    }
    return 0;
}

void NearConstraints::gradient(const NearConstraint& near, const Pose& pose,
                               std::span<double> out) const {
    const std::size_t k = near.index;
    const auto by_heading = out.subspan(2);
    std::fill(out.begin(), out.end(), 0.0);
    switch (near.kind) {
        case Kind::turn:
            by_heading[k] = -1;
            by_heading[k + 1] = 1;
            break;
        case Kind::point:
            point_gradient(k, near.fraction, near.nx, near.ny, pose, out);
            break;
        case Kind::corner: {
            // The line of the broom turns with it: what counts is its point next to the corner.
            const double along =
                (near.nx - pose.x[k]) * pose.ux[k] + (near.ny - pose.y[k]) * pose.uy[k];
            const double fraction = std::clamp(along / chain_.broom_length(), 0.0, 1.0);
            point_gradient(k, fraction, near.offset * pose.uy[k], -near.offset * pose.ux[k], pose,
                           out);
            break;
        }
        case Kind::first_closing_turn:
            closing_turn_gradient(0, 1, pose, by_heading);
            break;
        case Kind::last_closing_turn:
            closing_turn_gradient(chain_.broom_count() - 1, -1, pose, by_heading);
            break;
        case Kind::area:
            area_gradient(pose, by_heading);
            break;
        case Kind::closing_side:
            closing_side_gradient(pose, by_heading);
            break;
    }
}

void NearConstraints::point_gradient(std::size_t broom, double fraction, double nx, double ny,
                                     const Pose& pose, std::span<double> out) const {
    out[0] = nx;
    out[1] = ny;
    const double length = chain_.broom_length();
    for (std::size_t k = 0; k < chain_.broom_count(); ++k)
        out[2 + k] =
            length * chain_.lever(broom, fraction, k) * (ny * pose.ux[k] - nx * pose.uy[k]);
}

/// A closing turn is the sum over k of length * sin(heading_k - heading_end), or minus that.
void NearConstraints::closing_turn_gradient(std::size_t end, double sign, const Pose& pose,
                                            std::span<double> by_heading) const {
    double own = 0;
    for (std::size_t k = 0; k < chain_.broom_count(); ++k) {
        by_heading[k] =
            sign * chain_.broom_length() * (pose.ux[k] * pose.ux[end] + pose.uy[k] * pose.uy[end]);
        if (k != end) own -= by_heading[k];
    }
    by_heading[end] = own;
}

void NearConstraints::area_gradient(const Pose& pose, std::span<double> by_heading) const {
    const std::size_t n = chain_.asv_count();
    for (std::size_t k = 0; k < chain_.broom_count(); ++k) {
        const double x = (pose.x[k] - pose.x[0]) - (pose.x[n - 1] - pose.x[k + 1]);
        const double y = (pose.y[k] - pose.y[0]) - (pose.y[n - 1] - pose.y[k + 1]);
        by_heading[k] = 0.5 * chain_.broom_length() * (pose.ux[k] * x + pose.uy[k] * y);
    }
}

void NearConstraints::closing_side_gradient(const Pose& pose, std::span<double> by_heading) const {
    const std::size_t n = chain_.asv_count();
    const double rx = pose.x[0] - pose.x[n - 1], ry = pose.y[0] - pose.y[n - 1];
    const double closing = std::max(elementary::hypot(rx, ry), 1e-300);
    for (std::size_t k = 0; k < chain_.broom_count(); ++k)
        by_heading[k] = chain_.broom_length() * (rx * pose.uy[k] - ry * pose.ux[k]) / closing;
}

void NearConstraints::near_boxes(const Pose& pose, double radius) {
    const std::size_t pieces = std::max<std::size_t>(chain_.broom_count(), 1);
    for (std::size_t k = 0; k < pieces; ++k) {
        const std::size_t other = chain_.broom_count() == 0 ? k : k + 1;
        const auto consider = [&](std::size_t i, const geometry::Box& box) {
            near_box(k, i, box, pose, radius);
        };
        if (field_.few())
            for (std::size_t i = 0; i < field_.all().size(); ++i) consider(i, field_.all()[i]);
        else
            field_.visit_within({{pose.x[k], pose.y[k]}, {pose.x[other], pose.y[other]}}, radius,
                                consider);
    }
}

/// Keeps the broom on its side of the axis along which it is farthest from the box: both of its
/// ends off a side, or its line off a corner.
void NearConstraints::near_box(std::size_t k, std::size_t index, const geometry::Box& box,
                               const Pose& pose, double radius) {
    const bool point = chain_.broom_count() == 0;
    const std::size_t other = point ? k : k + 1;
    const double along_x = std::max(box.low.x - std::max(pose.x[k], pose.x[other]),
                                    std::min(pose.x[k], pose.x[other]) - box.high.x);
    const double along_y = std::max(box.low.y - std::max(pose.y[k], pose.y[other]),
                                    std::min(pose.y[k], pose.y[other]) - box.high.y);
    if (std::max(along_x, along_y) > radius) return;
    if (!point) {
        const double nx = -pose.uy[k], ny = pose.ux[k];
        const double middle = nx * (0.5 * (box.low.x + box.high.x) - pose.x[k]) +
                              ny * (0.5 * (box.low.y + box.high.y) - pose.y[k]);
        const double side = middle < 0 ? -1 : 1;
        const double corner_x = side * nx > 0 ? box.low.x : box.high.x;
        const double corner_y = side * ny > 0 ? box.low.y : box.high.y;
        const double across = side * (nx * (corner_x - pose.x[k]) + ny * (corner_y - pose.y[k]));
        if (across > radius) return;
        if (across > along_x && across > along_y) {
            near_.push_back({.kind = Kind::corner,
                             .index = k,
                             .box = index,
                             .nx = corner_x,
                             .ny = corner_y,
                             .offset = side});
            return;
        }
    }
    const bool by_x = along_x > along_y;
    const double low = by_x ? box.low.x : box.low.y, high = by_x ? box.high.x : box.high.y;
    for (const std::size_t end : {k, other}) {
        const double at = by_x ? pose.x[end] : pose.y[end];
        const double sign = low - at > at - high ? -1 : 1;
        near_.push_back({.kind = Kind::point,
                         .index = k,
                         .box = index,
                         .fraction = end == k ? 0.0 : 1.0,
                         .nx = by_x ? sign : 0,
                         .ny = by_x ? 0 : sign,
                         .offset = sign < 0 ? -low : high});
        if (point) break;
    }
}

void NearConstraints::near_bounds(const Pose& pose, double radius) {
    const geometry::Box& b = constraints_.bounds;
    const std::size_t last_broom = std::max<std::size_t>(chain_.broom_count(), 1) - 1;
    for (std::size_t j = 0; j < chain_.asv_count(); ++j) {
        const std::size_t broom = std::min(j, last_broom);
        const auto side = [&](double gap, double nx, double ny, double offset) {
            if (gap < radius)
                near_.push_back({.kind = Kind::point,
                                 .index = broom,
                                 .fraction = j == broom ? 0.0 : 1.0,
                                 .nx = nx,
                                 .ny = ny,
                                 .offset = offset});
        };
        side(pose.x[j] - b.low.x, 1, 0, b.low.x);
        side(b.high.x - pose.x[j], -1, 0, -b.high.x);
        side(pose.y[j] - b.low.y, 0, 1, b.low.y);
        side(b.high.y - pose.y[j], 0, -1, -b.high.y);
    }
}

}  // namespace asv::core
