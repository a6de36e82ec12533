#include "core/space/proof/collision_proof.hpp"

#include <algorithm>
#include <cmath>

namespace asv::core {

namespace {

/// One broom at the moment of a line, or the only ASV, against boxes.
class BroomProof {
  public:
    BroomProof(const LineMotion& motion, std::size_t broom, double rounding)
        : motion_(motion),
          pose_(motion.pose()),
          k_(broom),
          other_(motion.broom_end(broom)),
          rounding_(rounding) {}

    bool against(const ObstacleField& field, ProvenStretch& stretch) const {
        return field.few() ? scan(field.all(), stretch) : search(field, stretch);
    }

  private:
    bool search(const ObstacleField& field, ProvenStretch& stretch) const;
    bool scan(const NearBoxes& boxes, ProvenStretch& stretch) const;
    bool against(const geometry::Box& box, ProvenStretch& stretch) const;
    double farthest_motion(const ProvenStretch& stretch) const;

    double acceleration_bound() const {
        return std::max(motion_.acceleration_bound(k_), motion_.acceleration_bound(other_));
    }

    const LineMotion& motion_;
    const Pose& pose_;
    std::size_t k_, other_;  ///< its ends
    double rounding_;
};

/// How far the broom may come within the stretch, plus what rounding takes.
double BroomProof::farthest_motion(const ProvenStretch& stretch) const {
    const auto squared_speed = [&](std::size_t j) {
        return motion_.velocity_x(j) * motion_.velocity_x(j) +
               motion_.velocity_y(j) * motion_.velocity_y(j);
    };
    const double speed = std::sqrt(std::max(squared_speed(k_), squared_speed(other_)));
    const double farther = std::max(stretch.back, stretch.ahead);
    return (speed + 0.5 * acceleration_bound() * farther) * farther + rounding_;
}

bool BroomProof::search(const ObstacleField& field, ProvenStretch& stretch) const {
    const geometry::Segment broom{{pose_.x[k_], pose_.y[k_]}, {pose_.x[other_], pose_.y[other_]}};
    bool valid = true;
    field.visit_within(broom, farthest_motion(stretch), [&](std::size_t, const geometry::Box& box) {
        valid = valid && against(box, stretch);
    });
    return valid;
}

/// All boxes, by the gap along the axis that separates them most.
bool BroomProof::scan(const NearBoxes& boxes, ProvenStretch& stretch) const {
    const bool point = k_ == other_;
    const double x0 = std::min(pose_.x[k_], pose_.x[other_]),
                 x1 = std::max(pose_.x[k_], pose_.x[other_]);
    const double y0 = std::min(pose_.y[k_], pose_.y[other_]),
                 y1 = std::max(pose_.y[k_], pose_.y[other_]);
    const double nx = point ? 0 : -pose_.uy[k_], ny = point ? 0 : pose_.ux[k_];
    const double offset = nx * pose_.x[k_] + ny * pose_.y[k_];
    const double needed = farthest_motion(stretch);
    for (std::size_t b = 0; b < boxes.size(); ++b) {
        const double lx = boxes.low_x[b], ly = boxes.low_y[b];
        const double hx = boxes.high_x[b], hy = boxes.high_y[b];
        const double along_x = std::max(lx - x1, x0 - hx);
        const double along_y = std::max(ly - y1, y0 - hy);
        const double middle = 0.5 * (nx * (lx + hx) + ny * (ly + hy)) - offset;
        const double half = 0.5 * (std::abs(nx) * (hx - lx) + std::abs(ny) * (hy - ly));
        const double gap = std::max(std::max(along_x, along_y), std::abs(middle) - half);
        if (gap <= needed && !against(boxes[b], stretch)) return false;
    }
    return true;
}

bool BroomProof::against(const geometry::Box& box, ProvenStretch& stretch) const {
    const double acceleration = acceleration_bound();
    ProvenStretch best{-1, -1};
    // Along a fixed axis (ax, ay) both ends of the broom and the support of the box have to stay
    // apart; the best axis for each direction of time counts.
    const auto try_axis = [&](double ax, double ay, double support) {
        const double gap_0 = ax * pose_.x[k_] + ay * pose_.y[k_] - support - rounding_;
        const double gap_1 = ax * pose_.x[other_] + ay * pose_.y[other_] - support - rounding_;
        if (gap_0 <= 0 || gap_1 <= 0) return;
        ProvenStretch apart = stretch;
        apart.limit(gap_0, ax * motion_.velocity_x(k_) + ay * motion_.velocity_y(k_), acceleration);
        apart.limit(gap_1, ax * motion_.velocity_x(other_) + ay * motion_.velocity_y(other_),
                    acceleration);
        best.back = std::max(best.back, apart.back);
        best.ahead = std::max(best.ahead, apart.ahead);
    };
    try_axis(1, 0, box.high.x);
    try_axis(-1, 0, -box.low.x);
    try_axis(0, 1, box.high.y);
    try_axis(0, -1, -box.low.y);
    if (k_ != other_) {
        const double nx = -pose_.uy[k_], ny = pose_.ux[k_];
        const double middle = 0.5 * (nx * (box.low.x + box.high.x) + ny * (box.low.y + box.high.y));
        const double half = 0.5 * (std::abs(nx) * (box.high.x - box.low.x) +
                                   std::abs(ny) * (box.high.y - box.low.y));
        const double offset = nx * pose_.x[k_] + ny * pose_.y[k_];
        const double side = offset > middle ? 1 : -1;
        try_axis(side * nx, side * ny, side * middle + half);
    }
    if (best.ahead < 0) return false;
    stretch.back = std::min(stretch.back, best.back);
    stretch.ahead = std::min(stretch.ahead, best.ahead);
    return true;
}

}  // namespace

bool prove_collisions(const LineMotion& motion, const ObstacleField& field, double rounding,
                      ProvenStretch& stretch) {
    const std::size_t pieces = std::max<std::size_t>(motion.chain().broom_count(), 1);
    for (std::size_t k = 0; k < pieces; ++k)
        if (!BroomProof(motion, k, rounding).against(field, stretch)) return false;
    return true;
}

}  // namespace asv::core
