#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/chain/chain.hpp"

namespace asv::core {

/// A chain on a straight line in C-space, its parameter t in [0, 1]: where it is at one moment and
/// how fast, and how much that can change anywhere on the line. Every heading is linear in t.
/// Nothing is allocated after construction.
class LineMotion {
  public:
    /// Bounds on the second derivatives by t of what the closed polygon is asked for.
    struct ShapeCurvature {
        double first_closing_turn = 0, last_closing_turn = 0, closing_side = 0, area = 0;
    };

    /// Precondition: the chain outlives the motion.
    explicit LineMotion(const Chain& chain);

    /// Takes another line. Both rows have to stay as long as this one is in use.
    void begin(std::span<const double> from, std::span<const double> to);
    /// Goes to a moment of the line.
    void move_to(double t);

    const Chain& chain() const { return chain_; }
    /// Of the line: what each coordinate and each heading changes by from its start to its end.
    std::span<const double> step() const { return step_; }
    const std::vector<double>& heading_rate() const { return heading_rate_; }
    /// No ASV is faster anywhere on the line.
    double speed_bound() const { return speed_bound_; }
    /// No acceleration of this ASV is greater anywhere on the line.
    double acceleration_bound(std::size_t asv) const { return acceleration_[asv]; }
    const ShapeCurvature& shape_curvature() const { return shape_curvature_; }

    /// At the moment.
    std::span<const double> row() const { return row_; }
    const Pose& pose() const { return pose_; }
    double velocity_x(std::size_t asv) const { return velocity_x_[asv]; }
    double velocity_y(std::size_t asv) const { return velocity_y_[asv]; }

    /// The other end of the broom; the same ASV where there is but one.
    std::size_t broom_end(std::size_t broom) const {
        return chain_.broom_count() == 0 ? broom : broom + 1;
    }

  private:
    const Chain& chain_;
    std::span<const double> from_, to_;
    std::vector<double> step_, row_, heading_rate_;
    double speed_bound_ = 0;
    std::vector<double> acceleration_;
    std::vector<double> velocity_x_, velocity_y_;
    ShapeCurvature shape_curvature_;
    Pose pose_;
};

}  // namespace asv::core
