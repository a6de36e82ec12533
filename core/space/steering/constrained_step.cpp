#include "asv/core/space/steering/constrained_step.hpp"

#include <algorithm>
#include <cmath>

namespace asv::core {

namespace {

/// Shape margins at strictness 1: a share of the least area, and radians times broom length.
constexpr double area_margin = 0.02;
constexpr double turn_margin = 1e-4;
/// No ASV moves farther than this many times the root mean square motion of all of them, nearly
/// ever.
constexpr double fastest_share = 3;
/// Corrections for what the constraints bend; each brings the error from h to h^2.
constexpr int most_corrections = 2;

}  // namespace

ConstrainedStep::ConstrainedStep(const Chain& chain, const ChainConstraints& constraints,
                                 const ObstacleField& field, const Metric& metric)
    : chain_(chain),
      constraints_(constraints),
      field_(field),
      metric_(metric),
      row_(chain.dimension()),
      next_(chain.dimension()),
      pose_(chain.make_pose()),
      next_pose_(chain.make_pose()),
      heading_gradient_(chain.broom_count()),
      program_(chain.dimension()) {}

void ConstrainedStep::linearise(std::span<const double> row, double step_length, double margin,
                                double strictness) {
    std::copy(row.begin(), row.end(), row_.begin());
    chain_.forward(row, pose_);
    program_.clear();
    near_.clear();
    for (std::size_t i = 0; i < chain_.turn_count(); ++i) {
        const double room = row[3 + i] - constraints_.minimum_turn[i];
        if (room * metric_.scale(3 + i) <= step_length)
            add({.kind = Near::Kind::turn, .index = i}, 0, step_length);
    }
    near_boxes(step_length, margin);
    near_bounds(step_length, margin);
    near_shape(step_length, strictness);
}

/// Adds the constraint to the program unless no step of length reach can violate it.
void ConstrainedStep::add(Near near, double margin, double reach) {
    near.gap = gap(near, pose_, row_);
    // Down to the margin, and not at all where the gap is smaller already.
    near.change = -std::max(0.0, near.gap - margin);
    const auto row = program_.add_row(near.change);
    gradient(near, row);
    double square = 0;
    for (double value : row) square += value * value;
    if (square == 0 || near.change * near.change > reach * reach * square)
        program_.drop_row();
    else
        near_.push_back(near);
}

double ConstrainedStep::gap(const Near& near, const Pose& pose, std::span<const double> row) const {
    const std::size_t k = near.index;
    switch (near.kind) {
        case Near::Kind::turn:
            return row[3 + k] - constraints_.minimum_turn[k];
        case Near::Kind::point: {
            const std::size_t asv = near.fraction > 0 ? k + 1 : k;
            return near.nx * pose.x[asv] + near.ny * pose.y[asv] - near.offset;
        }
        case Near::Kind::corner:
            return near.offset *
                   (pose.ux[k] * (near.ny - pose.y[k]) - pose.uy[k] * (near.nx - pose.x[k]));
        case Near::Kind::first_turn:
            return first_turn(pose) - constraints_.minimum_first_turn;
        case Near::Kind::last_turn:
            return last_turn(pose) - constraints_.minimum_last_turn;
        case Near::Kind::area:
            return area(pose) - constraints_.minimum_area;
        case Near::Kind::closing:
            return closing_length(pose) - constraints_.minimum_closing;
    }
    return 0;
}

/// Fills row with the gradient of the gap in scaled coordinates.
void ConstrainedStep::gradient(const Near& near, std::span<double> row) {
    const std::size_t k = near.index, last = chain_.broom_count() - 1;
    if (near.kind == Near::Kind::turn) {
        std::fill(row.begin(), row.end(), 0.0);
        row[3 + k] = 1 / metric_.scale(3 + k);
        return;
    }
    if (near.kind == Near::Kind::point) {
        point_gradient(k, near.fraction, near.nx, near.ny, row);
        return;
    }
    if (near.kind == Near::Kind::corner) {
        // The line of the broom turns with it: what counts is its point next to the corner.
        const double along =
            (near.nx - pose_.x[k]) * pose_.ux[k] + (near.ny - pose_.y[k]) * pose_.uy[k];
        const double fraction = std::clamp(along / chain_.broom_length(), 0.0, 1.0);
        point_gradient(k, fraction, near.offset * pose_.uy[k], -near.offset * pose_.ux[k], row);
        return;
    }
    switch (near.kind) {
        case Near::Kind::first_turn:
            closing_turn_gradient(0, 1);
            break;
        case Near::Kind::last_turn:
            closing_turn_gradient(last, -1);
            break;
        case Near::Kind::area:
            area_gradient();
            break;
        default:
            closing_gradient();
            break;
    }
    row[0] = row[1] = 0;
    from_heading_gradient(row);
}

/// Turns the gradient by the headings of the brooms into one by the scaled coordinates.
void ConstrainedStep::from_heading_gradient(std::span<double> row) const {
    double sum = 0;
    for (std::size_t k = chain_.broom_count(); k-- > 0;) {
        sum += heading_gradient_[k];
        if (k > 0) row[2 + k] = sum;
    }
    row[2] = sum / metric_.scale(2);
    for (std::size_t i = 0; i < chain_.turn_count(); ++i)
        row[3 + i] = (row[3 + i] - chain_.heading_share()[i] * sum) / metric_.scale(3 + i);
}

/// Gradient of (nx, ny) . (point at that fraction of the broom).
void ConstrainedStep::point_gradient(std::size_t broom, double fraction, double nx, double ny,
                                     std::span<double> row) {
    row[0] = nx;
    row[1] = ny;
    if (chain_.broom_count() == 0) return;
    const double length = chain_.broom_length();
    for (std::size_t k = 0; k < chain_.broom_count(); ++k)
        heading_gradient_[k] =
            length * chain_.lever(broom, fraction, k) * (ny * pose_.ux[k] - nx * pose_.uy[k]);
    from_heading_gradient(row);
}

/// A closing turn is the sum over k of length * sin(heading_k - heading_end), or minus that.
void ConstrainedStep::closing_turn_gradient(std::size_t end, double sign) {
    double own = 0;
    for (std::size_t k = 0; k < chain_.broom_count(); ++k) {
        heading_gradient_[k] = sign * chain_.broom_length() *
                               (pose_.ux[k] * pose_.ux[end] + pose_.uy[k] * pose_.uy[end]);
        if (k != end) own -= heading_gradient_[k];
    }
    heading_gradient_[end] = own;
}

void ConstrainedStep::area_gradient() {
    const std::size_t n = chain_.asv_count();
    for (std::size_t k = 0; k < chain_.broom_count(); ++k) {
        const double x = (pose_.x[k] - pose_.x[0]) - (pose_.x[n - 1] - pose_.x[k + 1]);
        const double y = (pose_.y[k] - pose_.y[0]) - (pose_.y[n - 1] - pose_.y[k + 1]);
        heading_gradient_[k] = 0.5 * chain_.broom_length() * (pose_.ux[k] * x + pose_.uy[k] * y);
    }
}

void ConstrainedStep::closing_gradient() {
    const std::size_t n = chain_.asv_count();
    const double rx = pose_.x[0] - pose_.x[n - 1], ry = pose_.y[0] - pose_.y[n - 1];
    const double closing = std::max(std::hypot(rx, ry), 1e-300);
    for (std::size_t k = 0; k < chain_.broom_count(); ++k)
        heading_gradient_[k] =
            chain_.broom_length() * (rx * pose_.uy[k] - ry * pose_.ux[k]) / closing;
}

void ConstrainedStep::near_boxes(double step_length, double margin) {
    const double reach = fastest_share * step_length + margin;
    const std::size_t pieces = std::max<std::size_t>(chain_.broom_count(), 1);
    for (std::size_t k = 0; k < pieces; ++k) {
        const std::size_t other = chain_.broom_count() == 0 ? k : k + 1;
        const auto consider = [&](const geometry::Box& box) {
            near_box(k, box, step_length, margin);
        };
        if (field_.few())
            for (std::size_t b = 0; b < field_.all().size(); ++b) consider(field_.all()[b]);
        else
            field_.visit_within({{pose_.x[k], pose_.y[k]}, {pose_.x[other], pose_.y[other]}}, reach,
                                consider);
    }
}

/// Keeps the broom on its side of the axis along which it is farthest from the box: both of its
/// ends off a side, or its line off a corner.
void ConstrainedStep::near_box(std::size_t k, const geometry::Box& box, double step_length,
                               double margin) {
    const bool point = chain_.broom_count() == 0;
    const std::size_t other = point ? k : k + 1;
    const double along_x = std::max(box.low.x - std::max(pose_.x[k], pose_.x[other]),
                                    std::min(pose_.x[k], pose_.x[other]) - box.high.x);
    const double along_y = std::max(box.low.y - std::max(pose_.y[k], pose_.y[other]),
                                    std::min(pose_.y[k], pose_.y[other]) - box.high.y);
    const double reach = fastest_share * step_length + margin;
    if (std::max(along_x, along_y) > reach) return;
    if (!point) {
        const double nx = -pose_.uy[k], ny = pose_.ux[k];
        const double middle = nx * (0.5 * (box.low.x + box.high.x) - pose_.x[k]) +
                              ny * (0.5 * (box.low.y + box.high.y) - pose_.y[k]);
        const double side = middle < 0 ? -1 : 1;
        const double corner_x = side * nx > 0 ? box.low.x : box.high.x;
        const double corner_y = side * ny > 0 ? box.low.y : box.high.y;
        const double across = side * (nx * (corner_x - pose_.x[k]) + ny * (corner_y - pose_.y[k]));
        if (across > reach) return;
        if (across > along_x && across > along_y) {
            add({.kind = Near::Kind::corner,
                 .index = k,
                 .nx = corner_x,
                 .ny = corner_y,
                 .offset = side},
                margin, step_length);
            return;
        }
    }
    const bool by_x = along_x > along_y;
    const double low = by_x ? box.low.x : box.low.y, high = by_x ? box.high.x : box.high.y;
    for (const std::size_t end : {k, other}) {
        const double at = by_x ? pose_.x[end] : pose_.y[end];
        const double sign = low - at > at - high ? -1 : 1;
        add({.kind = Near::Kind::point,
             .index = k,
             .fraction = end == k ? 0.0 : 1.0,
             .nx = by_x ? sign : 0,
             .ny = by_x ? 0 : sign,
             .offset = sign < 0 ? -low : high},
            margin, step_length);
        if (point) break;
    }
}

void ConstrainedStep::near_bounds(double step_length, double margin) {
    const double reach = fastest_share * step_length + margin;
    const geometry::Box& b = constraints_.bounds;
    const std::size_t last_broom = std::max<std::size_t>(chain_.broom_count(), 1) - 1;
    for (std::size_t j = 0; j < chain_.asv_count(); ++j) {
        const std::size_t broom = std::min(j, last_broom);
        const auto side = [&](double gap, double nx, double ny, double offset) {
            if (gap < reach)
                add({.kind = Near::Kind::point,
                     .index = broom,
                     .fraction = j == broom ? 0.0 : 1.0,
                     .nx = nx,
                     .ny = ny,
                     .offset = offset},
                    margin, step_length);
        };
        side(pose_.x[j] - b.low.x, 1, 0, b.low.x);
        side(b.high.x - pose_.x[j], -1, 0, -b.high.x);
        side(pose_.y[j] - b.low.y, 0, 1, b.low.y);
        side(b.high.y - pose_.y[j], 0, -1, -b.high.y);
    }
}

void ConstrainedStep::near_shape(double step_length, double strictness) {
    if (chain_.asv_count() < 3) return;
    const double turn = strictness * turn_margin * chain_.broom_length();
    add({.kind = Near::Kind::first_turn}, turn, step_length);
    add({.kind = Near::Kind::last_turn}, turn, step_length);
    add({.kind = Near::Kind::area}, strictness * area_margin * constraints_.minimum_area,
        step_length);
    add({.kind = Near::Kind::closing}, 0, step_length);
}

void ConstrainedStep::pull(std::size_t asv, double dx, double dy, double stiffness) {
    const std::size_t last_broom = std::max<std::size_t>(chain_.broom_count(), 1) - 1;
    const std::size_t broom = std::min(asv, last_broom);
    const double fraction = asv == broom ? 0 : 1;
    point_gradient(broom, fraction, 1, 0, program_.add_row(dx, 1 / stiffness));
    point_gradient(broom, fraction, 0, 1, program_.add_row(dy, 1 / stiffness));
}

std::span<const double> ConstrainedStep::solve(std::span<const double> wish) {
    auto step = program_.solve(wish);
    take(step);
    for (int i = 0; i < most_corrections && correct(step); ++i) {
        step = program_.solve(wish);
        take(step);
    }
    return next_;
}

/// next_ = row_ + step, with turns that the solver left a little below straight put right.
void ConstrainedStep::take(std::span<const double> step) {
    for (std::size_t i = 0; i < next_.size(); ++i) next_[i] = row_[i] + step[i] / metric_.scale(i);
    const auto& least = constraints_.minimum_turn;
    for (std::size_t i = 0; i < least.size(); ++i) next_[3 + i] = std::max(next_[3 + i], least[i]);
}

/// Puts what the constraints bend over the step into their limits; false when none is violated.
bool ConstrainedStep::correct(std::span<const double> step) {
    chain_.forward(next_, next_pose_);
    bool violated = false;
    for (std::size_t r = 0; r < near_.size(); ++r) {
        const Near& near = near_[r];
        if (near.kind == Near::Kind::turn) continue;
        const auto gradient = program_.row(r);
        double predicted = near.gap;
        for (std::size_t i = 0; i < step.size(); ++i) predicted += gradient[i] * step[i];
        const double actual = gap(near, next_pose_, next_);
        // Half of what had to be left is close enough; a hair beyond the limit is not.
        if (actual < 0.5 * (near.gap + near.change)) violated = true;
        program_.set_limit(r, near.change + std::max(0.0, predicted - actual));
    }
    return violated;
}

}  // namespace asv::core
