#include "core/space/proof/line_motion.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/elementary/functions.hpp"

namespace asv::core {

LineMotion::LineMotion(const Chain& chain) : chain_(chain), pose_(chain.make_pose()) {
    step_.resize(chain.dimension());
    row_.resize(chain.dimension());
    heading_rate_.resize(chain.broom_count());
    for (auto* array : {&acceleration_, &velocity_x_, &velocity_y_})
        array->resize(chain.asv_count());
}

void LineMotion::begin(std::span<const double> from, std::span<const double> to) {
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
    speed_bound_ = elementary::hypot(step_[0], step_[1]) + length * greatest_speed;
    // The closing turns are L sum sin(heading_k - heading_end) and the area is L^2 / 2 times the
    // sum of sin(heading_j - heading_i) over i < j; a sine of a linear function has |''| <= rate^2.
    shape_curvature_.first_closing_turn = length * spread_first;
    shape_curvature_.last_closing_turn = length * spread_last;
    shape_curvature_.area = 0.5 * length * length *
                            std::max(0.0, static_cast<double>(brooms) * sum_of_squares - sum * sum);
    shape_curvature_.closing_side = length * sum_of_squares;
}

void LineMotion::move_to(double t) {
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

}  // namespace asv::core
