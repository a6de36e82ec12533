#include "core/generate/vouch/gate.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "geometry/elementary/functions.hpp"

namespace asv::core {

namespace {

// Between the chain and a mouth when it is about to enter or has just left.
constexpr double before_mouth = 0.002;

double distance(const Point& a, const Point& b) {
    return elementary::hypot(a.x - b.x, a.y - b.y);
}

bool interiors_meet(const Box& a, const Box& b) {
    return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

/// The outline that the joints stay on, from its end in the first room to its end in the second.
class Outline {
  public:
    Outline(const GateRail& rail, double broom_length)
        : rise_(std::min(rail.gate.height() - 2 * rail.slack, 0.8 * broom_length)),
          run_(std::sqrt(broom_length * broom_length - rise_ * rise_)),
          length_(broom_length) {
        const Box& free = rail.gate.free;
        axis_ = free.low.y + rail.slack;
        enter_ = free.low.x - before_mouth;
        leave_ = free.high.x + before_mouth;
        const double left = enter_ - run_ - rail.distance_before;
        const double right = leave_ + run_ + rail.distance_after;
        const double top = axis_ + rail.leg;
        corners_ = {{{enter_, top},
                     {left, top},
                     {left, axis_},
                     {right, axis_},
                     {right, top},
                     {leave_, top}}};
        for (std::size_t i = 0; i < corners_.size(); ++i)
            mark_[i] = i == 0 ? 0 : mark_[i - 1] + distance(corners_[i - 1], corners_[i]);
    }

    double run() const { return run_; }
    double axis() const { return axis_; }
    double enter() const { return enter_; }
    double leave() const { return leave_; }
    double end() const { return mark_.back(); }
    /// The mark of a point on the axis.
    double on_axis(double x) const { return mark_[2] + (x - corners_[2].x); }

    Point at(double mark) const {
        std::size_t i = 1;
        while (i + 1 < mark_.size() && mark > mark_[i]) ++i;
        const double share = (mark - mark_[i - 1]) / (mark_[i] - mark_[i - 1]);
        const Point &a = corners_[i - 1], &b = corners_[i];
        return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
    }

    /// The mark of the next joint, one broom away, behind (step -1) or ahead (step +1).
    std::optional<double> next(double mark, int step) const {
        const Point from = at(mark);
        double near = mark;
        for (const double corner : marks_beyond(mark, step)) {
            if (distance(at(corner), from) < length_) {
                near = corner;
                continue;
            }
            double far = corner;
            while (true) {
                const double middle = (near + far) / 2;
                if (middle == near || middle == far) return far;
                (distance(at(middle), from) < length_ ? near : far) = middle;
            }
        }
        return std::nullopt;
    }

    /// The ASV at an end of the chain, one broom from the joint at the mark: on the outline, but
    /// never nearer to the axis than the rise.
    std::optional<Point> end_asv(double mark, int step) const {
        const Point joint = at(mark);
        const auto on_outline = next(mark, step);
        if (on_outline && at(*on_outline).y >= axis_ + rise_) return at(*on_outline);
        if (joint.y > axis_ + 1e-9 * length_) return std::nullopt;
        return Point{joint.x + step * run_, axis_ + rise_};
    }

  private:
    std::vector<double> marks_beyond(double mark, int step) const {
        std::vector<double> marks;
        for (const double corner : mark_) {
            if (step > 0 ? corner > mark : corner < mark) marks.push_back(corner);
        }
        if (step < 0) std::reverse(marks.begin(), marks.end());
        return marks;
    }

    double rise_, run_, length_;
    double axis_ = 0, enter_ = 0, leave_ = 0;
    std::array<Point, 6> corners_;
    std::array<double, 6> mark_{};
};

}  // namespace

std::vector<Gate> find_gates(std::span<const Box> obstacles, double max_height) {
    std::vector<Gate> gates;
    for (const Box& below : obstacles) {
        for (const Box& above : obstacles) {
            const Box free{{std::max(below.low.x, above.low.x), below.high.y},
                           {std::min(below.high.x, above.high.x), above.low.y}};
            if (free.low.x >= free.high.x || free.low.y >= free.high.y ||
                free.high.y - free.low.y > max_height)
                continue;
            if (std::none_of(obstacles.begin(), obstacles.end(),
                             [&](const Box& box) { return interiors_meet(box, free); }))
                gates.push_back({free});
        }
    }
    return gates;
}

std::vector<Point> chain_on_rail(const GateRail& rail, std::size_t asv_count, double broom_length,
                                 double advance) {
    const Outline outline(rail, broom_length);
    const auto leader = outline.end_asv(advance, +1);
    if (!leader) return {};
    std::vector<Point> from_leader{*leader, outline.at(advance)};
    double mark = advance;
    while (from_leader.size() + 1 < asv_count) {
        const auto next = outline.next(mark, -1);
        if (!next) return {};
        mark = *next;
        from_leader.push_back(outline.at(mark));
    }
    const auto trailer = outline.end_asv(mark, -1);
    if (!trailer) return {};
    from_leader.push_back(*trailer);
    if (rail.mirrored) {
        const double twice_middle = rail.gate.free.low.y + rail.gate.free.high.y;
        for (Point& point : from_leader) point.y = twice_middle - point.y;
    } else {
        std::reverse(from_leader.begin(), from_leader.end());
    }
    return from_leader;
}

RailSpan rail_span(const GateRail& rail, std::size_t asv_count, double broom_length) {
    const Outline outline(rail, broom_length);
    // By symmetry the last joint stands where the first one did; the first is asv_count - 3 ahead.
    double leave = outline.on_axis(outline.leave() + outline.run());
    for (std::size_t i = 0; i + 3 < asv_count; ++i)
        leave = outline.next(leave, +1).value_or(outline.end());
    return {outline.on_axis(outline.enter() - outline.run()), leave};
}

}  // namespace asv::core
