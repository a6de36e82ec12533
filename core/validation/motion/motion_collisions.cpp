#include "core/validation/motion/motion_collisions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace asv::core::validation {
namespace {

using geometry::Box;
using geometry::Point;
using geometry::Segment;

/// What is not settled in so short a part of the step, some 1e-12 of motion, counts as contact.
constexpr double resolution = 1e-9;

Segment at(const MovingBroom& broom, double t) {
    return {broom.a.at(t), broom.b.at(t)};
}

Box around(const Segment& first, const Segment& second) {
    const Box a = geometry::bounds(first);
    const Box b = geometry::bounds(second);
    return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
            {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

/// Separates a moving broom from a box over parts of the motion. A segment and a box are apart
/// exactly when an axis or the segment's normal separates them. During [begin, end] an axis does
/// so throughout when it does for both ends of the broom at both times, since these move straight.
/// The segment's line passes the box throughout when all four corners stay strictly on one side,
/// which are four quadratics of the time.
class Separation {
  public:
    Separation(const MovingBroom& broom, const Box& box) : broom_(broom), box_(box) {
        const Moving along = difference(broom.a, broom.b);
        std::size_t i = 0;
        for (const double x : {box.low.x, box.high.x}) {
            for (const double y : {box.low.y, box.high.y}) {
                const Moving corner{{x, y}, {x, y}};
                sides_[i++] = cross(along, difference(broom.a, corner));
            }
        }
    }

    std::optional<double> first_contact(double begin, double end) const {
        if (apart_on_axis(begin, end) || apart_on_normal(begin, end)) return std::nullopt;
        if (end - begin < resolution) return begin;
        const double middle = begin + (end - begin) / 2;
        const std::optional<double> contact = first_contact(begin, middle);
        return contact ? contact : first_contact(middle, end);
    }

  private:
    bool apart_on_axis(double begin, double end) const {
        const Box swept = around(at(broom_, begin), at(broom_, end));
        // Interpolation rounds by a few half ulps of the largest coordinate.
        const double size = std::max({std::abs(swept.low.x), std::abs(swept.low.y),
                                      std::abs(swept.high.x), std::abs(swept.high.y)});
        const Box safe = geometry::grown(swept, 4 * std::numeric_limits<double>::epsilon() * size);
        return safe.high.x < box_.low.x || safe.low.x > box_.high.x || safe.high.y < box_.low.y ||
               safe.low.y > box_.high.y;
    }

    bool apart_on_normal(double begin, double end) const {
        const auto positive = [&](const Quadratic& q) { return q.least(begin, end) > 0; };
        const auto negative = [&](const Quadratic& q) { return (-1.0 * q).least(begin, end) > 0; };
        return std::all_of(sides_.begin(), sides_.end(), positive) ||
               std::all_of(sides_.begin(), sides_.end(), negative);
    }

    const MovingBroom& broom_;
    const Box& box_;
    std::array<Quadratic, 4> sides_;
};

/// The tightest of some times of the motion, with the verdict of the proof.
Finding judge(const MovingBroom& broom, const Box& box) {
    constexpr std::array<double, 5> times = {0, 0.25, 0.5, 0.75, 1};
    Finding worst;
    const auto look = [&](double t) {
        Finding finding = clearance(at(broom, t), box);
        finding.offender.time = t;
        keep_worse(worst, finding);
    };
    for (const double t : times) look(t);
    if (const std::optional<double> contact = first_contact(broom, box)) {
        look(*contact);
        worst.ok = false;
        worst.offender.room = std::min(worst.offender.room, 0.0);
    }
    return worst;
}

}  // namespace

std::optional<double> first_contact(const MovingBroom& broom, const Box& box) {
    return Separation(broom, box).first_contact(0, 1);
}

Finding check_motion_collisions(const Motion& motion, const Obstacles& obstacles, double radius) {
    Finding worst;
    for (std::size_t i = 0; i + 1 < motion.size(); ++i) {
        const MovingBroom broom{motion[i], motion[i + 1]};
        // A point of the broom moves as a mean of its ends, so no farther than the farther one.
        const double moved = 1.000001 * std::max(distance(broom.a.from, broom.a.to),
                                                 distance(broom.b.from, broom.b.to));
        double near = std::max(std::min(radius, worst.offender.room), 0.0) + moved;
        obstacles.tree().for_each_near(at(broom, 0), near, [&](std::size_t index, const Box& box) {
            Finding finding = judge(broom, box);
            finding.offender.broom = i;
            finding.offender.obstacle = index;
            near = std::clamp(finding.offender.room + moved, moved, near);
            keep_worse(worst, finding);
        });
    }
    return worst;
}

}  // namespace asv::core::validation
