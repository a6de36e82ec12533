#include "asv/core/space/steering/constrained_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asv::core {

namespace {

/// Sweeps of the dual solver: enough that a chain in a corridor moves along it, few enough to be cheap.
constexpr int most_sweeps = 30;
/// A step that violates no row by more than this share of its length is good enough.
constexpr double accuracy = 1e-3;
/// Shape margins at strictness 1: a share of the least area, and radians times broom length.
constexpr double area_margin = 0.02;
constexpr double turn_margin = 1e-4;

}  // namespace

ConstrainedStep::ConstrainedStep(const Chain& chain, const ChainConstraints& constraints,
                                 const ObstacleField& field, const Metric& metric)
    : chain_(chain),
      constraints_(constraints),
      field_(field),
      metric_(metric),
      pose_(chain.make_pose()),
      heading_gradient_(chain.broom_count()),
      turn_limit_(chain.turn_count()),
      turn_multiplier_(chain.turn_count()),
      step_(chain.dimension()) {}

void ConstrainedStep::linearise(std::span<const double> row, double step_length, double margin,
                                double strictness) {
    chain_.forward(row, pose_);
    row_count_ = 0;
    rows_.clear();
    for (auto* array : {&limit_, &norm_, &multiplier_, &compliance_}) array->clear();
    for (std::size_t i = 0; i < chain_.turn_count(); ++i)
        turn_limit_[i] =
            std::min(0.0, (constraints_.minimum_turn[i] - row[3 + i]) * metric_.scale(3 + i));
    near_boxes(step_length, margin);
    near_bounds(step_length, margin);
    near_shape(step_length, strictness);
}

double* ConstrainedStep::add_row(double limit, double compliance) {
    const std::size_t d = chain_.dimension();
    rows_.resize((row_count_ + 1) * d);
    limit_.push_back(limit);
    compliance_.push_back(compliance);
    multiplier_.push_back(0);
    ++row_count_;
    return rows_.data() + (row_count_ - 1) * d;
}

/// Finishes the row just added; drops it when no step of length reach can violate it.
void ConstrainedStep::keep_row(double reach) {
    const std::size_t d = chain_.dimension();
    const double* row = rows_.data() + (row_count_ - 1) * d;
    double square = 0;
    for (std::size_t i = 0; i < d; ++i) square += row[i] * row[i];
    if (compliance_.back() == 0 && (square == 0 || -limit_.back() > reach * std::sqrt(square))) {
        --row_count_;
        for (auto* array : {&limit_, &compliance_, &multiplier_}) array->pop_back();
        return;
    }
    norm_.push_back(square);
}

/// Turns the gradient by the headings of the brooms into one by the scaled coordinates.
void ConstrainedStep::from_heading_gradient(double* row) {
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
                                double* row) {
    row[0] = nx;
    row[1] = ny;
    if (chain_.broom_count() == 0) return;
    const double length = chain_.broom_length();
    for (std::size_t k = 0; k < chain_.broom_count(); ++k)
        heading_gradient_[k] = length * chain_.lever(broom, fraction, k) *
                               (ny * pose_.ux[k] - nx * pose_.uy[k]);
    from_heading_gradient(row);
}

void ConstrainedStep::near_boxes(double step_length, double margin) {
    // Root mean square motion of the chain to that of its fastest point.
    const double reach = 3 * step_length + margin;
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
        for (std::size_t k = 0; k < pieces; ++k) {
            const std::size_t other = chain_.broom_count() == 0 ? k : k + 1;
            const double along_x =
                std::max(box.low.x - std::max(pose_.x[k], pose_.x[other]),
                         std::min(pose_.x[k], pose_.x[other]) - box.high.x);
            const double along_y =
                std::max(box.low.y - std::max(pose_.y[k], pose_.y[other]),
                         std::min(pose_.y[k], pose_.y[other]) - box.high.y);
            double across = -1, side = 1, nx = 0, ny = 0, support_x = 0, support_y = 0;
            if (chain_.broom_count() > 0) {
                nx = -pose_.uy[k];
                ny = pose_.ux[k];
                const double offset = nx * pose_.x[k] + ny * pose_.y[k];
                const double middle =
                    0.5 * (nx * (box.low.x + box.high.x) + ny * (box.low.y + box.high.y));
                side = middle > offset ? 1 : -1;
                support_x = side * nx > 0 ? box.low.x : box.high.x;
                support_y = side * ny > 0 ? box.low.y : box.high.y;
                across = side * (nx * support_x + ny * support_y - offset);
            }
            if (std::max({along_x, along_y, across}) > reach) continue;
            const auto room = [&](double gap) { return -std::max(0.0, gap - margin); };
            if (across > along_x && across > along_y) {
                // The corner against the line of the broom, which turns with it.
                const double fraction =
                    std::clamp(((support_x - pose_.x[k]) * pose_.ux[k] +
                                (support_y - pose_.y[k]) * pose_.uy[k]) / chain_.broom_length(),
                               0.0, 1.0);
                point_row(k, fraction, -side * nx, -side * ny, add_row(room(across)));
                keep_row(step_length);
                continue;
            }
            const bool by_x = along_x > along_y;
            for (const std::size_t end : {k, other}) {
                const double gap_low = by_x ? box.low.x - pose_.x[end] : box.low.y - pose_.y[end];
                const double gap_high = by_x ? pose_.x[end] - box.high.x : pose_.y[end] - box.high.y;
                const double sign = gap_low > gap_high ? -1 : 1;
                const std::size_t broom = std::min(end, pieces - 1);
                point_row(broom, end == broom ? 0 : 1, by_x ? sign : 0, by_x ? 0 : sign,
                          add_row(room(std::max(gap_low, gap_high))));
                keep_row(step_length);
                if (end == other) break;
            }
        }
    }
}

void ConstrainedStep::near_bounds(double step_length, double margin) {
    const double reach = 3 * step_length + margin;
    const geometry::Box& b = constraints_.bounds;
    const std::size_t last_piece = std::max<std::size_t>(chain_.broom_count(), 1) - 1;
    const auto side = [&](std::size_t j, double gap, double nx, double ny) {
        if (gap > reach) return;
        const std::size_t broom = std::min(j, last_piece);
        point_row(broom, j == broom ? 0 : 1, nx, ny, add_row(-std::max(0.0, gap - margin)));
        keep_row(step_length);
    };
    for (std::size_t j = 0; j < chain_.asv_count(); ++j) {
        side(j, pose_.x[j] - b.low.x, 1, 0);
        side(j, b.high.x - pose_.x[j], -1, 0);
        side(j, pose_.y[j] - b.low.y, 0, 1);
        side(j, b.high.y - pose_.y[j], 0, -1);
    }
}

void ConstrainedStep::near_shape(double step_length, double strictness) {
    if (chain_.asv_count() < 3) return;
    const double length = chain_.broom_length();
    const std::size_t brooms = chain_.broom_count();
    const auto room = [](double gap, double margin) { return -std::max(0.0, gap - margin); };
    const auto shape_row = [&](double limit) {
        double* row = add_row(limit);
        row[0] = row[1] = 0;
        from_heading_gradient(row);
        keep_row(step_length);
    };
    // The sum of length * sin(heading_k - heading_end) over k, and its gradient.
    const auto closing_turn = [&](std::size_t end, double sign, double value, double minimum) {
        double own = 0;
        for (std::size_t k = 0; k < brooms; ++k) {
            const double cosine = pose_.ux[k] * pose_.ux[end] + pose_.uy[k] * pose_.uy[end];
            heading_gradient_[k] = sign * length * cosine;
            if (k != end) own -= heading_gradient_[k];
        }
        heading_gradient_[end] = own;
        shape_row(room(value - minimum, strictness * turn_margin * length));
    };
    closing_turn(0, 1, first_turn(pose_), constraints_.minimum_first_turn);
    closing_turn(brooms - 1, -1, last_turn(pose_), constraints_.minimum_last_turn);

    const std::size_t n = chain_.asv_count();
    for (std::size_t k = 0; k < brooms; ++k) {
        const double x = (pose_.x[k] - pose_.x[0]) - (pose_.x[n - 1] - pose_.x[k + 1]);
        const double y = (pose_.y[k] - pose_.y[0]) - (pose_.y[n - 1] - pose_.y[k + 1]);
        heading_gradient_[k] = 0.5 * length * (pose_.ux[k] * x + pose_.uy[k] * y);
    }
    shape_row(room(area(pose_) - constraints_.minimum_area,
                   strictness * area_margin * constraints_.minimum_area));

    const double rx = pose_.x[0] - pose_.x[n - 1], ry = pose_.y[0] - pose_.y[n - 1];
    const double closing = std::hypot(rx, ry);
    if (closing == 0) return;
    for (std::size_t k = 0; k < brooms; ++k)
        heading_gradient_[k] = length * (rx * pose_.uy[k] - ry * pose_.ux[k]) / closing;
    shape_row(room(closing - constraints_.minimum_closing, 0));
}

void ConstrainedStep::pull(std::size_t asv, double dx, double dy, double stiffness) {
    const std::size_t last_piece = std::max<std::size_t>(chain_.broom_count(), 1) - 1;
    const std::size_t broom = std::min(asv, last_piece);
    const double fraction = asv == broom ? 0 : 1;
    point_row(broom, fraction, 1, 0, add_row(dx, 1 / stiffness));
    keep_row(0);
    point_row(broom, fraction, 0, 1, add_row(dy, 1 / stiffness));
    keep_row(0);
}

std::span<const double> ConstrainedStep::solve(std::span<const double> wish) {
    const std::size_t d = chain_.dimension();
    std::copy(wish.begin(), wish.end(), step_.begin());
    std::fill(turn_multiplier_.begin(), turn_multiplier_.end(), 0.0);
    pushed_ = false;
    double wish_square = 0;
    for (double w : wish) wish_square += w * w;
    const double good = accuracy * accuracy * std::max(wish_square, 1e-12);
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        double change = 0;
        for (std::size_t i = 0; i < turn_limit_.size(); ++i) {
            const double wanted = turn_multiplier_[i] + turn_limit_[i] - step_[3 + i];
            const double delta = std::max(0.0, wanted) - turn_multiplier_[i];
            turn_multiplier_[i] += delta;
            step_[3 + i] += delta;
            change = std::max(change, delta * delta);
        }
        for (std::size_t r = 0; r < row_count_; ++r) {
            const double* row = rows_.data() + r * d;
            double value = 0;
            for (std::size_t i = 0; i < d; ++i) value += row[i] * step_[i];
            const bool spring = compliance_[r] > 0;
            double delta = (limit_[r] - value - compliance_[r] * multiplier_[r]) /
                           (norm_[r] + compliance_[r]);
            if (!spring) delta = std::max(delta, -multiplier_[r]);
            if (delta == 0) continue;
            multiplier_[r] += delta;
            for (std::size_t i = 0; i < d; ++i) step_[i] += delta * row[i];
            change = std::max(change, delta * delta * norm_[r]);
        }
        if (change > 0) pushed_ = true;
        if (change <= good) break;
    }
    return step_;
}

}  // namespace asv::core
