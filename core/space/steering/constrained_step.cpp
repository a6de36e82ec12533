#include "asv/core/space/steering/constrained_step.hpp"

#include <algorithm>
#include <cmath>

namespace asv::core {

namespace {

/// Shape margins at strictness 1: a share of the least area, and radians times broom length.
constexpr double area_margin = 0.02;
constexpr double turn_margin = 1e-4;
/// No ASV moves farther than this many times the root mean square motion of all of them, nearly ever.
constexpr double fastest_share = 3;

/// How much a gap may change: down to the margin, and not at all where it is smaller already.
double allowed_change(double gap, double margin) { return -std::max(0.0, gap - margin); }

}  // namespace

ConstrainedStep::ConstrainedStep(const Chain& chain, const ChainConstraints& constraints,
                                 const ObstacleField& field, const Metric& metric)
    : chain_(chain),
      constraints_(constraints),
      field_(field),
      metric_(metric),
      pose_(chain.make_pose()),
      heading_gradient_(chain.broom_count()),
      program_(chain.dimension()) {}

void ConstrainedStep::linearise(std::span<const double> row, double step_length, double margin,
                                double strictness) {
    chain_.forward(row, pose_);
    program_.clear();
    near_turns(row, step_length);
    near_boxes(step_length, margin);
    near_bounds(step_length, margin);
    near_shape(step_length, strictness);
}

/// Leaves the last row in the program unless no step of length reach can violate it.
void ConstrainedStep::keep(double limit, double reach, std::span<const double> row) {
    double square = 0;
    for (double value : row) square += value * value;
    if (square == 0 || (limit < 0 && limit * limit > reach * reach * square)) program_.drop_row();
}

/// Turns the gradient by the headings of the brooms into one by the scaled coordinates.
void ConstrainedStep::from_heading_gradient(std::span<double> row) {
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
void ConstrainedStep::point_row(std::size_t broom, double fraction, double nx, double ny,
                                std::span<double> row) {
    row[0] = nx;
    row[1] = ny;
    if (chain_.broom_count() == 0) return;
    const double length = chain_.broom_length();
    for (std::size_t k = 0; k < chain_.broom_count(); ++k)
        heading_gradient_[k] = length * chain_.lever(broom, fraction, k) *
                               (ny * pose_.ux[k] - nx * pose_.uy[k]);
    from_heading_gradient(row);
}

void ConstrainedStep::keep_point(std::size_t broom, double fraction, double nx, double ny,
                                 double limit, double reach) {
    const auto row = program_.add_row(limit);
    point_row(broom, fraction, nx, ny, row);
    keep(limit, reach, row);
}

void ConstrainedStep::keep_shape(double limit, double reach) {
    const auto row = program_.add_row(limit);
    row[0] = row[1] = 0;
    from_heading_gradient(row);
    keep(limit, reach, row);
}

void ConstrainedStep::near_turns(std::span<const double> configuration, double step_length) {
    for (std::size_t i = 0; i < chain_.turn_count(); ++i) {
        const double room =
            (configuration[3 + i] - constraints_.minimum_turn[i]) * metric_.scale(3 + i);
        if (room > step_length) continue;
        const auto row = program_.add_row(-std::max(0.0, room));
        std::fill(row.begin(), row.end(), 0.0);
        row[3 + i] = 1;
    }
}

void ConstrainedStep::near_boxes(double step_length, double margin) {
    const double reach = fastest_share * step_length + margin;
    const auto [x0, x1] = std::minmax_element(pose_.x.begin(), pose_.x.end());
    const auto [y0, y1] = std::minmax_element(pose_.y.begin(), pose_.y.end());
    const geometry::Box region = geometry::grown({{*x0, *y0}, {*x1, *y1}}, reach);
    const NearBoxes& boxes = field_.few() ? field_.all() : field_.near(region, near_);
    const std::size_t pieces = std::max<std::size_t>(chain_.broom_count(), 1);
    for (std::size_t b = 0; b < boxes.size(); ++b) {
        const geometry::Box box = boxes[b];
        if (box.low.x > region.high.x || box.high.x < region.low.x || box.low.y > region.high.y ||
            box.high.y < region.low.y)
            continue;
        for (std::size_t k = 0; k < pieces; ++k) near_box(k, box, step_length, margin);
    }
}

/// Keeps the broom on its side of the axis along which it is farthest from the box: both of its ends
/// off a side, or its line off a corner.
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
        double nx = -pose_.uy[k], ny = pose_.ux[k];
        const double middle_x = 0.5 * (box.low.x + box.high.x) - pose_.x[k];
        const double middle_y = 0.5 * (box.low.y + box.high.y) - pose_.y[k];
        if (nx * middle_x + ny * middle_y > 0) {
            nx = -nx;
            ny = -ny;
        }
        const double corner_x = (nx < 0 ? box.low.x : box.high.x) - pose_.x[k];
        const double corner_y = (ny < 0 ? box.low.y : box.high.y) - pose_.y[k];
        const double across = -(nx * corner_x + ny * corner_y);
        if (across > reach) return;
        if (across > along_x && across > along_y) {
            const double fraction =
                (corner_x * pose_.ux[k] + corner_y * pose_.uy[k]) / chain_.broom_length();
            keep_point(k, std::clamp(fraction, 0.0, 1.0), nx, ny, allowed_change(across, margin),
                       step_length);
            return;
        }
    }
    for (const std::size_t end : {k, other}) {
        const bool by_x = along_x > along_y;
        const double below = by_x ? box.low.x - pose_.x[end] : box.low.y - pose_.y[end];
        const double above = by_x ? pose_.x[end] - box.high.x : pose_.y[end] - box.high.y;
        const double sign = below > above ? -1 : 1;
        keep_point(k, end == k ? 0 : 1, by_x ? sign : 0, by_x ? 0 : sign,
                   allowed_change(std::max(below, above), margin), step_length);
        if (point) break;
    }
}

void ConstrainedStep::near_bounds(double step_length, double margin) {
    const double reach = fastest_share * step_length + margin;
    const geometry::Box& b = constraints_.bounds;
    const std::size_t last_broom = std::max<std::size_t>(chain_.broom_count(), 1) - 1;
    for (std::size_t j = 0; j < chain_.asv_count(); ++j) {
        const std::size_t broom = std::min(j, last_broom);
        const double fraction = j == broom ? 0 : 1;
        const auto side = [&](double gap, double nx, double ny) {
            if (gap < reach)
                keep_point(broom, fraction, nx, ny, allowed_change(gap, margin), step_length);
        };
        side(pose_.x[j] - b.low.x, 1, 0);
        side(b.high.x - pose_.x[j], -1, 0);
        side(pose_.y[j] - b.low.y, 0, 1);
        side(b.high.y - pose_.y[j], 0, -1);
    }
}

void ConstrainedStep::near_shape(double step_length, double strictness) {
    if (chain_.asv_count() < 3) return;
    const double length = chain_.broom_length();
    const std::size_t brooms = chain_.broom_count(), n = chain_.asv_count();
    // A closing turn is the sum over k of length * sin(heading_k - heading_end), or minus that.
    const auto closing_turn = [&](std::size_t end, double sign, double room) {
        double own = 0;
        for (std::size_t k = 0; k < brooms; ++k) {
            heading_gradient_[k] =
                sign * length * (pose_.ux[k] * pose_.ux[end] + pose_.uy[k] * pose_.uy[end]);
            if (k != end) own -= heading_gradient_[k];
        }
        heading_gradient_[end] = own;
        keep_shape(allowed_change(room, strictness * turn_margin * length), step_length);
    };
    closing_turn(0, 1, first_turn(pose_) - constraints_.minimum_first_turn);
    closing_turn(brooms - 1, -1, last_turn(pose_) - constraints_.minimum_last_turn);

    for (std::size_t k = 0; k < brooms; ++k) {
        const double x = (pose_.x[k] - pose_.x[0]) - (pose_.x[n - 1] - pose_.x[k + 1]);
        const double y = (pose_.y[k] - pose_.y[0]) - (pose_.y[n - 1] - pose_.y[k + 1]);
        heading_gradient_[k] = 0.5 * length * (pose_.ux[k] * x + pose_.uy[k] * y);
    }
    keep_shape(allowed_change(area(pose_) - constraints_.minimum_area,
                              strictness * area_margin * constraints_.minimum_area),
               step_length);

    const double rx = pose_.x[0] - pose_.x[n - 1], ry = pose_.y[0] - pose_.y[n - 1];
    const double closing = std::hypot(rx, ry);
    if (closing == 0) return;
    for (std::size_t k = 0; k < brooms; ++k)
        heading_gradient_[k] = length * (rx * pose_.uy[k] - ry * pose_.ux[k]) / closing;
    keep_shape(allowed_change(closing - constraints_.minimum_closing, 0), step_length);
}

void ConstrainedStep::pull(std::size_t asv, double dx, double dy, double stiffness) {
    const std::size_t last_broom = std::max<std::size_t>(chain_.broom_count(), 1) - 1;
    const std::size_t broom = std::min(asv, last_broom);
    const double fraction = asv == broom ? 0 : 1;
    point_row(broom, fraction, 1, 0, program_.add_row(dx, 1 / stiffness));
    point_row(broom, fraction, 0, 1, program_.add_row(dy, 1 / stiffness));
}

}  // namespace asv::core
