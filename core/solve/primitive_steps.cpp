#include "core/solve/primitive_steps.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace asv::core {

namespace {

/// A step may fall short of the limit by this share of it: far above the rounding of positions.
constexpr double shortfall = 1e-9;
/// Some half a millisecond of work.
constexpr std::size_t positions_between_looks = 1000;

/// Walks along the rows; a place is a way point's index plus a fraction of the motion behind it.
class Walk {
  public:
    Walk(const Problem& problem, const Configurations& rows, MotionChecker& checker)
        : problem_(problem),
          rows_(rows),
          checker_(checker),
          chain_(checker.chain()),
          limit_(problem.requirements.max_step),
          end_(static_cast<double>(rows.size() / chain_.dimension() - 1)),
          pose_(chain_.make_pose()),
          from_(chain_.dimension()),
          to_(chain_.dimension()),
          state_(problem.start),
          path_(problem.asv_count()) {}

    /// None when the deadline comes first.
    std::optional<Path> run(Clock::time_point deadline) {
        std::size_t placed = 0;  // positions since the last look at the clock
        path_.push_back(state_);
        double place = 0;
        double stride = 0.1;
        while (place < end_) {
            double next = std::max(farthest(place, stride), place + 1e-12);
            const double way_point = std::floor(place) + 1;
            if (next > way_point && !passes(place, next)) next = up_to(way_point, place);
            stride = std::max(next - place, 1e-9);
            place = next;
            stand_at(place);
            path_.push_back(state_);
            placed += state_.size();
            if (placed < positions_between_looks) continue;
            placed = 0;
            if (Clock::now() >= deadline) return std::nullopt;
        }
        return std::move(path_);
    }

  private:
    void configuration(double place, std::vector<double>& row) const {
        const std::size_t d = chain_.dimension();
        const auto index = std::min(static_cast<std::size_t>(place), rows_.size() / d - 1);
        const double t = place - static_cast<double>(index);
        const double* a = rows_.data() + index * d;
        for (std::size_t i = 0; i < d; ++i) row[i] = t == 0 ? a[i] : a[i] + t * (a[d + i] - a[i]);
    }

    /// Moves the state to a place; the goal itself is taken from the problem.
    void stand_at(double place) {
        if (place >= end_) {
            state_ = problem_.goal;
            return;
        }
        configuration(place, to_);
        chain_.forward(to_, pose_);
        copy_positions(pose_, state_);
    }

    /// How far the fastest ASV is from the state when the chain is at the place.
    double moved(double place) {
        configuration(std::min(place, end_), to_);
        chain_.forward(to_, pose_);
        const bool at_goal = place >= end_;
        double most = 0;
        for (std::size_t j = 0; j < state_.size(); ++j) {
            const double x = at_goal ? problem_.goal[j].x : pose_.x[j];
            const double y = at_goal ? problem_.goal[j].y : pose_.y[j];
            const double dx = x - state_[j].x, dy = y - state_[j].y;
            most = std::max(most, dx * dx + dy * dy);
        }
        return std::sqrt(most);
    }

    /// The farthest place that one step reaches: where moved() passes the limit for the first time,
    /// looked for from the last stride on by false position. It aims at the middle of the range
    /// that is good enough, so that rounding does not keep it on one side.
    double farthest(double place, double stride) {
        double near = place, near_moved = 0;
        double far = std::min(place + stride, end_);
        double far_moved = moved(far);
        const double longest = limit_ * (1 - shortfall / 4), least = limit_ * (1 - shortfall);
        while (far_moved <= longest) {
            if (far >= end_) return end_;
            near = far;
            near_moved = far_moved;
            stride *= 1.5;
            far = std::min(far + stride, end_);
            far_moved = moved(far);
        }
        const double aim = (least + longest) / 2;
        for (int i = 0; i < 60 && near_moved < least; ++i) {
            double share = (aim - near_moved) / (far_moved - near_moved);
            if (i % 4 == 3) share = 0.5;
            const double middle = near + share * (far - near);
            if (middle <= near || middle >= far) break;
            const double middle_moved = moved(middle);
            (middle_moved <= longest ? near : far) = middle;
            (middle_moved <= longest ? near_moved : far_moved) = middle_moved;
        }
        return near;
    }

    /// The way point behind the place, or how far one step comes on the motion to it: the path may
    /// go out to a way point and come back within the stride that was looked at.
    double up_to(double way_point, double place) {
        if (moved(way_point) <= limit_) return way_point;
        return std::max(farthest(place, way_point - place), place + 1e-12);
    }

    bool passes(double place, double next) {
        configuration(place, from_);
        configuration(next, to_);
        return checker_.valid(from_, to_);
    }

    const Problem& problem_;
    const Configurations& rows_;
    MotionChecker& checker_;
    const Chain& chain_;
    double limit_;
    double end_;
    Pose pose_;
    std::vector<double> from_, to_;
    std::vector<Point> state_;
    Path path_;
};

}  // namespace

Path primitive_steps(const Problem& problem, const Configurations& rows, MotionChecker& checker) {
    return *primitive_steps_before(Clock::time_point::max(), problem, rows, checker);
}

std::optional<Path> primitive_steps_before(Clock::time_point deadline, const Problem& problem,
                                           const Configurations& rows, MotionChecker& checker) {
    return Walk(problem, rows, checker).run(deadline);
}

}  // namespace asv::core
