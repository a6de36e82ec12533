#include "core/space/steering/constrained_step.hpp"

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
constexpr int max_corrections = 2;

}  // namespace

using Kind = NearConstraint::Kind;

ConstrainedStep::ConstrainedStep(const Chain& chain, const ChainConstraints& constraints,
                                 const ObstacleField& field, const Metric& metric)
    : chain_(chain),
      constraints_(constraints),
      metric_(metric),
      near_(chain, constraints, field),
      row_(chain.dimension()),
      next_(chain.dimension()),
      gradient_(chain.dimension()),
      pose_(chain.make_pose()),
      next_pose_(chain.make_pose()),
      program_(chain.dimension()) {}

void ConstrainedStep::linearise(std::span<const double> row, double step_length, double margin,
                                double strictness) {
    std::copy(row.begin(), row.end(), row_.begin());
    chain_.forward(row, pose_);
    program_.clear();
    heeded_.clear();
    for (const NearConstraint& near : near_.find(pose_, fastest_share * step_length + margin)) {
        double kept = 0;
        if (near.kind == Kind::point || near.kind == Kind::corner)
            kept = margin;
        else if (near.kind == Kind::first_closing_turn || near.kind == Kind::last_closing_turn)
            kept = strictness * turn_margin * chain_.broom_length();
        else if (near.kind == Kind::area)
            kept = strictness * area_margin * constraints_.min_area;
        heed(near, kept, step_length);
    }
}

/// Adds the constraint to the program unless no step of that length can violate it.
void ConstrainedStep::heed(const NearConstraint& near, double margin, double step_length) {
    const double gap = near_.gap(near, row_, pose_);
    // Down to the margin, and not at all where the gap is smaller already.
    const double change = -std::max(0.0, gap - margin);
    if (near.kind == Kind::turn && -change * metric_.scale(3 + near.index) > step_length) return;
    near_.gradient(near, pose_, gradient_);
    const auto row = program_.add_row(change);
    to_scaled(gradient_, row);
    double square = 0;
    for (double value : row) square += value * value;
    if (square == 0 || change * change > step_length * step_length * square)
        program_.drop_row();
    else
        heeded_.push_back({near, gap, change});
}

/// Turns derivatives by heading coordinates into those by the scaled coordinates.
void ConstrainedStep::to_scaled(std::span<const double> gradient, std::span<double> row) const {
    row[0] = gradient[0];
    row[1] = gradient[1];
    if (chain_.broom_count() == 0) return;
    double sum = 0;
    for (std::size_t k = chain_.broom_count(); k-- > 0;) {
        sum += gradient[2 + k];
        if (k > 0) row[2 + k] = sum;
    }
    row[2] = sum / metric_.scale(2);
    for (std::size_t i = 0; i < chain_.turn_count(); ++i)
        row[3 + i] = (row[3 + i] - chain_.heading_share()[i] * sum) / metric_.scale(3 + i);
}

void ConstrainedStep::pull(std::size_t asv, double dx, double dy, double stiffness) {
    const std::size_t last_broom = std::max<std::size_t>(chain_.broom_count(), 1) - 1;
    const std::size_t broom = std::min(asv, last_broom);
    const double fraction = asv == broom ? 0 : 1;
    near_.point_gradient(broom, fraction, 1, 0, pose_, gradient_);
    to_scaled(gradient_, program_.add_row(dx, 1 / stiffness));
    near_.point_gradient(broom, fraction, 0, 1, pose_, gradient_);
    to_scaled(gradient_, program_.add_row(dy, 1 / stiffness));
}

std::span<const double> ConstrainedStep::solve(std::span<const double> wish) {
    auto step = program_.solve(wish);
    take(step);
    for (int i = 0; i < max_corrections && correct(step); ++i) {
        step = program_.solve_again();
        take(step);
    }
    return next_;
}

/// next_ = row_ + step, with turns that the solver left a little below straight put right.
void ConstrainedStep::take(std::span<const double> step) {
    for (std::size_t i = 0; i < next_.size(); ++i) next_[i] = row_[i] + step[i] / metric_.scale(i);
    const auto& least = constraints_.min_turn;
    for (std::size_t i = 0; i < least.size(); ++i) next_[3 + i] = std::max(next_[3 + i], least[i]);
}

/// Puts what the constraints bend over the step into their limits; false when none is violated.
bool ConstrainedStep::correct(std::span<const double> step) {
    chain_.forward(next_, next_pose_);
    bool violated = false;
    for (std::size_t r = 0; r < heeded_.size(); ++r) {
        const Heeded& heeded = heeded_[r];
        if (heeded.near.kind == Kind::turn) continue;
        const auto gradient = program_.row(r);
        double predicted = heeded.gap;
        for (std::size_t i = 0; i < step.size(); ++i) predicted += gradient[i] * step[i];
        const double actual = near_.gap(heeded.near, next_, next_pose_);
        // Half of what had to be left is close enough; a hair beyond the limit is not.
        if (actual < 0.5 * (heeded.gap + heeded.change)) violated = true;
        program_.set_limit(r, heeded.change + std::max(0.0, predicted - actual));
    }
    return violated;
}

}  // namespace asv::core
