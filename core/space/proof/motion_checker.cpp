#include "core/space/proof/motion_checker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asv::core {

namespace {

/// A gap of a few coordinates around 1 is right to some 1e-15: what is less is no room at an
/// obstacle, and no violation of the shape. In units of the coordinates' size, their extent.
constexpr double relative_rounding = 1e-14;

/// Among many boxes, how far a moment may prove at most, in mean distances of the boxes.
constexpr double max_spacings = 2;

/// A gap of the line that is shorter than this motion and still open counts as blocked; likewise.
constexpr double relative_finest_motion = 1e-7;

/// Shortens reach to where g + slope s - curvature s^2 / 2 may become negative; false if g is, or
/// is no number.
bool limit(double g, double slope, double curvature, double& back, double& ahead) {
    if (!(g >= 0)) return false;
    const double farther = std::max(back, ahead);
    if (g >= (std::abs(slope) + 0.5 * curvature * farther) * farther) return true;
    const double root = std::sqrt(slope * slope + 2 * curvature * g);
    // The positive zero, in the form that does not cancel.
    const auto zero = [&](double s) {
        if (s < 0) return 2 * g / (root - s);
        return curvature > 0 ? (root + s) / curvature : std::numeric_limits<double>::infinity();
    };
    ahead = std::min(ahead, zero(slope));
    back = std::min(back, zero(-slope));
    return true;
}

}  // namespace

MotionChecker::MotionChecker(const Chain& chain, const ChainConstraints& constraints,
                             const ObstacleField& field)
    : chain_(chain),
      constraints_(constraints),
      field_(field),
      rounding_(relative_rounding * constraints.extent),
      finest_motion_(relative_finest_motion * constraints.extent),
      pose_(chain.make_pose()) {
    step_.resize(chain.dimension());
    row_.resize(chain.dimension());
    heading_rate_.resize(chain.broom_count());
    for (auto* array : {&acceleration_, &velocity_x_, &velocity_y_})
        array->resize(chain.asv_count());
}

bool MotionChecker::valid(std::span<const double> row) {
    return prove(row, row, 1, true) >= 1;
}

bool MotionChecker::valid(std::span<const double> from, std::span<const double> to) {
    return prove(from, to, 1, true) >= 1;
}

double MotionChecker::valid_prefix(std::span<const double> from, std::span<const double> to,
                                   double resolution) {
    return prove(from, to, resolution, false);
}

double MotionChecker::prove(std::span<const double> from, std::span<const double> to,
                            double resolution, bool only_yes) {
    ++motion_checks_;
    begin_line(from, to);
    const Reach last = reach(1, 1, 0);
    bool blocked = last.back < 0;
    double blocked_at = 1;  // the first parameter that is known to be invalid, if there is one
    if (blocked && only_yes) return -1;
    if (last.back >= 1) return 1;
    const Reach first = reach(0, 0, blocked ? 1 : 1 - last.back);
    if (first.ahead < 0) return -1;

    gaps_.clear();
    gaps_.push_back({first.ahead, blocked ? 1 : 1 - last.back});
    while (!gaps_.empty()) {
        const Gap gap = gaps_.back();
        gaps_.pop_back();
        const double length = gap.end - gap.begin;
        if (length <= 0) continue;
        if (length * speed_bound_ <= (blocked && gaps_.empty() ? resolution : finest_motion_))
            return gap.begin;
        const double middle = 0.5 * (gap.begin + gap.end);
        const Reach proven = reach(middle, middle - gap.begin, gap.end - middle);
        if (proven.back < 0) {
            if (only_yes) return gap.begin;
            blocked = true;
            blocked_at = middle;
            gaps_.clear();
            gaps_.push_back({gap.begin, middle});
            continue;
        }
        // A stack: the earlier part on top, so that what is left of it is where the line stops. A
        // part that is proven up to the other end leaves no gap, not even one by rounding.
        if (proven.ahead < gap.end - middle) gaps_.push_back({middle + proven.ahead, gap.end});
        if (proven.back < middle - gap.begin) gaps_.push_back({gap.begin, middle - proven.back});
    }
    // Proven right up to a state that is invalid by rounding alone.
    return blocked ? std::nextafter(blocked_at, 0.0) : 1;
}

void MotionChecker::begin_line(std::span<const double> from, std::span<const double> to) {
    from_ = from;
    to_ = to;
    for (std::size_t i = 0; i < step_.size(); ++i) step_[i] = to[i] - from[i];
    chain_.headings(step_, heading_rate_);
    const double length = chain_.broom_length();
    const std::size_t brooms = chain_.broom_count();
    // |p_j'| <= |anchor'| + L sum |lever| |rate|, |p_j''| <= L sum |lever| rate^2. Levers change by
    // 1 from ASV to ASV, so the sums are carried along the chain.
    double speed = 0, acceleration = 0, sum = 0, sum_of_squares = 0, spread_first = 0,
           spread_last = 0;
    for (std::size_t k = 0; k < brooms; ++k) {
        const double rate = heading_rate_[k];
        speed += std::abs(chain_.lever(0, 0, k) * rate);
        acceleration += std::abs(chain_.lever(0, 0, k)) * rate * rate;
        sum += rate;
        sum_of_squares += rate * rate;
        const double to_first = rate - heading_rate_.front(), to_last = rate - heading_rate_.back();
        spread_first += to_first * to_first;
        spread_last += to_last * to_last;
    }
    double greatest_speed = speed;
    acceleration_[0] = length * acceleration;
    for (std::size_t j = 1; j < chain_.asv_count(); ++j) {
        const double rate = heading_rate_[j - 1];
        const double change =
            std::abs(chain_.lever(j, 0, j - 1)) - std::abs(chain_.lever(j - 1, 0, j - 1));
        speed += change * std::abs(rate);
        acceleration += change * rate * rate;
        greatest_speed = std::max(greatest_speed, speed);
        acceleration_[j] = length * acceleration;
    }
    speed_bound_ = std::hypot(step_[0], step_[1]) + length * greatest_speed;
    // The closing turns are L sum sin(heading_k - heading_end) and the area is L^2 / 2 times the
    // sum of sin(heading_j - heading_i) over i < j; a sine of a linear function has |''| <= rate^2.
    turn_curvature_first_ = length * spread_first;
    turn_curvature_last_ = length * spread_last;
    area_curvature_ = 0.5 * length * length *
                      std::max(0.0, static_cast<double>(brooms) * sum_of_squares - sum * sum);
    closing_curvature_ = length * sum_of_squares;
}

MotionChecker::Reach MotionChecker::reach(double t, double back, double ahead) {
    ++state_checks_;
    constexpr Reach invalid{-1, -1};
    move_along(t);
    if (!field_.few()) {
        // Among many boxes, only those near by are looked at, so only near by can be proven.
        const double near = max_spacings * field_.spacing() / std::max(speed_bound_, 1e-300);
        back = std::min(back, near);
        ahead = std::min(ahead, near);
    }
    Reach result{back, ahead};
    for (std::size_t i = 0; constraints_.shaped && i < chain_.turn_count(); ++i) {
        const double turn = row_[3 + i], rate = step_[3 + i];
        // Straight joints are common, and interpolating between them rounds.
        if (!limit(turn - constraints_.min_turn[i] + rounding_, rate, 0, result.back,
                   result.ahead) ||
            !limit(constraints_.max_turn - turn, -rate, 0, result.back, result.ahead))
            return invalid;
    }
    if (!bounds_reach(result) || !shape_reach(result) || !obstacle_reach(result)) return invalid;
    return result;
}

void MotionChecker::move_along(double t) {
    for (std::size_t i = 0; i < row_.size(); ++i) row_[i] = from_[i] + t * step_[i];
    if (t == 1) std::copy(to_.begin(), to_.end(), row_.begin());
    chain_.forward(row_, pose_);
    const double length = chain_.broom_length();
    double vx = step_[0], vy = step_[1];
    for (std::size_t k = 0; k < chain_.broom_count(); ++k) {
        const double pull = length * chain_.anchor_lever()[k] * heading_rate_[k];
        vx -= pull * pose_.uy[k];
        vy += pull * pose_.ux[k];
    }
    velocity_x_[0] = vx;
    velocity_y_[0] = vy;
    for (std::size_t k = 0; k < chain_.broom_count(); ++k) {
        const double own = chain_.link_length(k);
        velocity_x_[k + 1] = vx -= own * heading_rate_[k] * pose_.uy[k];
        velocity_y_[k + 1] = vy += own * heading_rate_[k] * pose_.ux[k];
    }
}

bool MotionChecker::shape_reach(Reach& reach) const {
    const std::size_t n = chain_.asv_count();
    if (!constraints_.shaped || n < 3) return true;
    const double rx = pose_.x[0] - pose_.x[n - 1], ry = pose_.y[0] - pose_.y[n - 1];
    const double rvx = velocity_x_[0] - velocity_x_[n - 1];
    const double rvy = velocity_y_[0] - velocity_y_[n - 1];
    const auto cross = [](double ax, double ay, double bx, double by) { return ax * by - ay * bx; };
    const double first_ux = pose_.ux.front(), first_uy = pose_.uy.front();
    const double last_ux = pose_.ux.back(), last_uy = pose_.uy.back();
    const double first_rate = heading_rate_.front(), last_rate = heading_rate_.back();

    const double first =
        cross(rx, ry, first_ux, first_uy) - constraints_.min_first_turn + rounding_;
    const double first_slope =
        cross(rvx, rvy, first_ux, first_uy) + first_rate * cross(rx, ry, -first_uy, first_ux);
    if (!limit(first, first_slope, turn_curvature_first_, reach.back, reach.ahead)) return false;
    const double last = cross(last_ux, last_uy, rx, ry) - constraints_.min_last_turn + rounding_;
    const double last_slope =
        cross(last_ux, last_uy, rvx, rvy) + last_rate * cross(-last_uy, last_ux, rx, ry);
    if (!limit(last, last_slope, turn_curvature_last_, reach.back, reach.ahead)) return false;

    const double closing = std::hypot(rx, ry);
    const double closing_slope = closing > 0 ? (rx * rvx + ry * rvy) / closing : 0;
    // A distance bends upwards where it bends by moving sideways, so only r'' can lower it.
    if (!limit(closing - constraints_.min_closing + rounding_, closing_slope, closing_curvature_,
               reach.back, reach.ahead))
        return false;

    double twice = 0, twice_slope = 0;
    for (std::size_t i = 2; i < n; ++i) {
        const double ax = pose_.x[i - 1] - pose_.x[0], ay = pose_.y[i - 1] - pose_.y[0];
        const double bx = pose_.x[i] - pose_.x[0], by = pose_.y[i] - pose_.y[0];
        twice += cross(ax, ay, bx, by);
        twice_slope +=
            cross(velocity_x_[i - 1] - velocity_x_[0], velocity_y_[i - 1] - velocity_y_[0], bx,
                  by) +
            cross(ax, ay, velocity_x_[i] - velocity_x_[0], velocity_y_[i] - velocity_y_[0]);
    }
    return limit(0.5 * twice - constraints_.min_area + rounding_, 0.5 * twice_slope,
                 area_curvature_, reach.back, reach.ahead);
}

bool MotionChecker::bounds_reach(Reach& reach) const {
    const Box& b = constraints_.bounds;
    for (std::size_t j = 0; j < chain_.asv_count(); ++j) {
        const double a = acceleration_[j], vx = velocity_x_[j], vy = velocity_y_[j];
        if (!limit(pose_.x[j] - b.low.x, vx, a, reach.back, reach.ahead) ||
            !limit(b.high.x - pose_.x[j], -vx, a, reach.back, reach.ahead) ||
            !limit(pose_.y[j] - b.low.y, vy, a, reach.back, reach.ahead) ||
            !limit(b.high.y - pose_.y[j], -vy, a, reach.back, reach.ahead))
            return false;
    }
    return true;
}

bool MotionChecker::obstacle_reach(Reach& reach) const {
    const std::size_t pieces = std::max<std::size_t>(chain_.broom_count(), 1);
    for (std::size_t k = 0; k < pieces; ++k)
        if (!(field_.few() ? scan_boxes(k, reach) : search_boxes(k, reach))) return false;
    return true;
}

/// How far the broom may come within the reach, plus what rounding takes.
double MotionChecker::farthest_motion(std::size_t k, const Reach& reach) const {
    const std::size_t other = chain_.broom_count() == 0 ? k : k + 1;
    const double speed = std::sqrt(std::max(
        velocity_x_[k] * velocity_x_[k] + velocity_y_[k] * velocity_y_[k],
        velocity_x_[other] * velocity_x_[other] + velocity_y_[other] * velocity_y_[other]));
    const double acceleration = std::max(acceleration_[k], acceleration_[other]);
    const double farther = std::max(reach.back, reach.ahead);
    return (speed + 0.5 * acceleration * farther) * farther + rounding_;
}

bool MotionChecker::search_boxes(std::size_t k, Reach& reach) const {
    const std::size_t other = chain_.broom_count() == 0 ? k : k + 1;
    const geometry::Segment broom{{pose_.x[k], pose_.y[k]}, {pose_.x[other], pose_.y[other]}};
    bool valid = true;
    field_.visit_within(broom, farthest_motion(k, reach),
                        [&](std::size_t, const geometry::Box& box) {
                            valid = valid && broom_reach(k, box, reach);
                        });
    return valid;
}

/// All boxes against one broom, by the gap along the axis that separates them most.
bool MotionChecker::scan_boxes(std::size_t k, Reach& reach) const {
    const NearBoxes& boxes = field_.all();
    const bool point = chain_.broom_count() == 0;
    const std::size_t other = point ? k : k + 1;
    const double x0 = std::min(pose_.x[k], pose_.x[other]),
                 x1 = std::max(pose_.x[k], pose_.x[other]);
    const double y0 = std::min(pose_.y[k], pose_.y[other]),
                 y1 = std::max(pose_.y[k], pose_.y[other]);
    const double nx = point ? 0 : -pose_.uy[k], ny = point ? 0 : pose_.ux[k];
    const double offset = nx * pose_.x[k] + ny * pose_.y[k];
    const double needed = farthest_motion(k, reach);
    for (std::size_t b = 0; b < boxes.size(); ++b) {
        const double lx = boxes.low_x[b], ly = boxes.low_y[b];
        const double hx = boxes.high_x[b], hy = boxes.high_y[b];
        const double along_x = std::max(lx - x1, x0 - hx);
        const double along_y = std::max(ly - y1, y0 - hy);
        const double middle = 0.5 * (nx * (lx + hx) + ny * (ly + hy)) - offset;
        const double half = 0.5 * (std::abs(nx) * (hx - lx) + std::abs(ny) * (hy - ly));
        const double gap = std::max(std::max(along_x, along_y), std::abs(middle) - half);
        if (gap <= needed && !broom_reach(k, boxes[b], reach)) return false;
    }
    return true;
}

bool MotionChecker::broom_reach(std::size_t k, const geometry::Box& box, Reach& reach) const {
    const std::size_t other = chain_.broom_count() == 0 ? k : k + 1;
    const double acceleration = std::max(acceleration_[k], acceleration_[other]);
    double back = -1, ahead = -1;
    // Along a fixed axis (ax, ay) both ends of the broom and the support of the box have to stay
    // apart; the best axis for each direction of time counts.
    const auto try_axis = [&](double ax, double ay, double support) {
        const double gap_0 = ax * pose_.x[k] + ay * pose_.y[k] - support - rounding_;
        const double gap_1 = ax * pose_.x[other] + ay * pose_.y[other] - support - rounding_;
        if (gap_0 <= 0 || gap_1 <= 0) return;
        double axis_back = reach.back, axis_ahead = reach.ahead;
        limit(gap_0, ax * velocity_x_[k] + ay * velocity_y_[k], acceleration, axis_back,
              axis_ahead);
        limit(gap_1, ax * velocity_x_[other] + ay * velocity_y_[other], acceleration, axis_back,
              axis_ahead);
        back = std::max(back, axis_back);
        ahead = std::max(ahead, axis_ahead);
    };
    try_axis(1, 0, box.high.x);
    try_axis(-1, 0, -box.low.x);
    try_axis(0, 1, box.high.y);
    try_axis(0, -1, -box.low.y);
    if (chain_.broom_count() > 0) {
        double nx = -pose_.uy[k], ny = pose_.ux[k];
        const double middle = 0.5 * (nx * (box.low.x + box.high.x) + ny * (box.low.y + box.high.y));
        const double half = 0.5 * (std::abs(nx) * (box.high.x - box.low.x) +
                                   std::abs(ny) * (box.high.y - box.low.y));
        const double offset = nx * pose_.x[k] + ny * pose_.y[k];
        const double side = offset > middle ? 1 : -1;
        try_axis(side * nx, side * ny, side * middle + half);
    }
    if (ahead < 0) return false;
    reach.back = std::min(reach.back, back);
    reach.ahead = std::min(reach.ahead, ahead);
    return true;
}

}  // namespace asv::core
