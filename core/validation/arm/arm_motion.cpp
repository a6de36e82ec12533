#include "core/validation/arm/arm_motion.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/elementary/functions.hpp"
#include "geometry/predicates/distance.hpp"

namespace asv::core::validation {

namespace {

using geometry::Box;
using geometry::Point;
using geometry::Segment;

/// What is not settled in so short a part of the step counts as violated.
constexpr double shortest_part = 1e-9;

/// Lengths are wrong by some 1e-15 of the coordinates' size.
constexpr double rounding = 1e-14;

double size_of(const Segment& segment) {
    return std::max({std::abs(segment.a.x), std::abs(segment.a.y), std::abs(segment.b.x),
                     std::abs(segment.b.y)});
}

/// The first time in [begin, end] that is not proven to be clear, where clear(time, time to either
/// side) says that a whole part is.
template <class Clear>
std::optional<double> first_unproven(double begin, double end, const Clear& clear) {
    const double middle = begin + (end - begin) / 2;
    if (clear(middle, end - middle)) return std::nullopt;
    if (end - begin < shortest_part) return begin;
    const std::optional<double> found = first_unproven(begin, middle, clear);
    return found ? found : first_unproven(middle, end, clear);
}

/// The tightest of some times, with the verdict of the proof; room(t) is what is left at a time.
template <class Room>
Finding judge(const Room& room, double bound) {
    Finding worst;
    const auto look = [&](double t) {
        Finding finding;
        finding.offender.room = room(t);
        finding.ok = finding.offender.room > 0;
        finding.offender.time = t;
        keep_worse(worst, finding);
    };
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) look(t);
    if (!worst.ok) return worst;
    const auto clear = [&](double t, double around) { return room(t) > bound * around; };
    if (const std::optional<double> unproven = first_unproven(0, 1, clear)) {
        look(*unproven);
        worst.ok = false;
        worst.offender.room = std::min(worst.offender.room, 0.0);
    }
    return worst;
}

}  // namespace

ArmMotion::ArmMotion(const std::vector<double>& links, const Point& base, std::vector<double> from,
                     std::vector<double> to)
    : links_(links), base_(base), from_(std::move(from)), to_(std::move(to)) {
    double sum = 0;
    for (std::size_t i = 0; i < links_.size(); ++i)
        bound_.push_back(sum += links_[i] * std::abs(to_[i] - from_[i]));
}

Segment ArmMotion::link(std::size_t i, double t) const {
    Point a = base_, b = base_;
    for (std::size_t k = 0; k <= i; ++k) {
        const double heading = from_[k] + t * (to_[k] - from_[k]);
        a = b;
        b = {a.x + links_[k] * elementary::cos(heading),
             a.y + links_[k] * elementary::sin(heading)};
    }
    return {a, b};
}

Finding check_arm_motion_bounds(const ArmMotion& motion, const Requirements& requirements) {
    const Box box = geometry::grown(requirements.bounds, requirements.tolerance);
    Finding worst;
    for (std::size_t i = 0; i < motion.link_count(); ++i) {
        const auto room = [&](double t) {
            const Segment link = motion.link(i, t);
            const Point& p = link.b;
            return std::min(
                       {p.x - box.low.x, p.y - box.low.y, box.high.x - p.x, box.high.y - p.y}) -
                   rounding * size_of(link);
        };
        Finding finding = judge(room, motion.bound(i));
        finding.offender.asv = i + 1;
        keep_worse(worst, finding);
    }
    return worst;
}

Finding check_arm_motion_collisions(const ArmMotion& motion, const Obstacles& obstacles,
                                    double radius) {
    Finding worst;
    for (std::size_t i = 0; i < motion.link_count(); ++i) {
        const double moved = 1.000001 * motion.bound(i);
        const double near = std::max(std::min(radius, worst.offender.room), 0.0) + moved;
        obstacles.tree().for_each_near(
            motion.link(i, 0), near, [&](std::size_t index, const Box& box) {
                const auto room = [&](double t) {
                    const Segment link = motion.link(i, t);
                    const double apart = geometry::distance(link, box);
                    return apart > 0 ? apart - rounding * size_of(link) : -penetration(link, box);
                };
                Finding finding = judge(room, motion.bound(i));
                finding.offender.broom = i;
                finding.offender.obstacle = index;
                keep_worse(worst, finding);
            });
    }
    return worst;
}

}  // namespace asv::core::validation
