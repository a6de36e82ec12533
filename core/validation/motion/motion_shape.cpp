#include "core/validation/motion/motion_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "core/validation/state_checks.hpp"

namespace asv::core::validation {
namespace {

using geometry::Point;
using std::numbers::pi;

Finding at_time(bool ok, double time, double room) {
    Finding finding;
    finding.ok = ok;
    finding.offender.time = time;
    finding.offender.room = room;
    return finding;
}

Quadratic twice_the_area(const Motion& motion) {
    Quadratic sum;
    for (std::size_t i = 2; i < motion.size(); ++i) {
        sum = sum + cross(difference(motion[0], motion[i - 1]), difference(motion[0], motion[i]));
    }
    // Each addition rounds coefficients of at most 18 U V each, which is 18/512 of the error over
    // h.
    sum.error *= 1 + static_cast<double>(motion.size()) / 16;
    return sum;
}

/// The side from ASV i to the next one; the last is the closing side.
Moving side(const Motion& motion, std::size_t i) {
    return difference(motion[i], motion[(i + 1) % motion.size()]);
}

double turn(const Moving& u, const Moving& v, double t) {
    const Point a = u.at(t);
    const Point b = v.at(t);
    return std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
}

/// One turn over time, from side u to side v.
struct Joint {
    Finding finding;
    bool never_against = false;  ///< proven to turn with the orientation, or not at all
};

// With a = sign * turn, cross * cos(e) * sign + dot * sin(e) is |u| |v| sin(a + e). Where it is
// not negative, a is in [-e, pi - e]. That refuses turns within e of pi, which come with next to
// no area, and needs no more than a quadratic.
Joint check_joint(const Moving& u, const Moving& v, double sign, double e) {
    const Quadratic turning = sign * cross(u, v);
    const Quadratic rotated = std::cos(e) * turning + std::sin(e) * dot(u, v);
    const double time = rotated.place_of_least(0, 1);
    const double angle = sign * turn(u, v, time);
    Joint joint;
    joint.never_against = turning.least(0, 1) >= 0;
    double room = std::min(angle + e, pi - e - angle);
    const bool ok = rotated.least(0, 1) >= 0;
    // A proof that fails within rounding leaves no room, whatever the angle looks like.
    if (!ok) room = std::min(room, -std::numeric_limits<double>::epsilon());
    joint.finding = at_time(ok, time, room);
    return joint;
}

/// The first side that could not be proven to keep some length; room 0.
std::optional<Finding> vanishing_side(const Motion& motion) {
    for (std::size_t i = 0; i < motion.size(); ++i) {
        const Quadratic squared = dot(side(motion, i), side(motion, i));
        if (squared.least(0, 1) > 0) continue;
        Finding finding = at_time(false, squared.place_of_least(0, 1), 0);
        finding.offender.asv = i;
        return finding;
    }
    return std::nullopt;
}

}  // namespace

Finding check_motion_broom_lengths(const Motion& motion, const Requirements& requirements) {
    const double shortest = requirements.broom_length - requirements.tolerance;
    const double longest = requirements.broom_length + requirements.tolerance;
    Finding worst;
    for (std::size_t i = 0; i + 1 < motion.size(); ++i) {
        const Quadratic squared = dot(side(motion, i), side(motion, i));
        const Quadratic negated = -1.0 * squared;
        const double low = squared.least(0, 1);
        const double high = -negated.least(0, 1);
        const bool long_enough = shortest <= 0 || low >= shortest * shortest;
        Finding finding = at_time(long_enough, squared.place_of_least(0, 1),
                                  std::sqrt(std::max(low, 0.0)) - shortest);
        keep_worse(finding, at_time(high <= longest * longest, negated.place_of_least(0, 1),
                                    longest - std::sqrt(high)));
        finding.offender.broom = i;
        keep_worse(worst, finding);
    }
    return worst;
}

// As long as no side is a point and no turn reaches pi, turns change continuously, and so does
// their sum, which for a closed polygon is a multiple of 2 pi: it keeps its value at time 0. The
// sum of their sizes exceeds it by twice those that go against the orientation, by e at most.
Finding check_motion_convexity(const Motion& motion, const Requirements& requirements) {
    const std::size_t n = motion.size();
    if (n < 2) return {};
    // Beyond a right angle the sine above says nothing more; a smaller tolerance is stricter.
    const double e = std::min(requirements.tolerance, 1.0);
    const double sign = twice_the_area(motion).at(0) < 0 ? -1 : 1;
    // Turns at a side that is a point mean nothing, so this comes first.
    if (std::optional<Finding> point = vanishing_side(motion)) return *point;
    double total = 0;
    double against = 0;
    Finding worst;
    for (std::size_t i = 0; i < n; ++i) {
        const Moving last = side(motion, (i + n - 1) % n);
        const Moving next = side(motion, i);
        Joint joint = check_joint(last, next, sign, e);
        joint.finding.offender.asv = i;
        total += sign * turn(last, next, 0);
        if (!joint.never_against) against += 2 * e;
        keep_worse(worst, joint.finding);
    }
    const double room = 3 * pi - (2 * pi * std::round(total / (2 * pi)) + against);
    keep_worse(worst, at_time(room >= 0 && total > pi, 0, room));
    return worst;
}

Finding check_motion_area(const Motion& motion, const Requirements& requirements) {
    const double least = requirements.min_area(motion.size()) - requirements.tolerance;
    const Quadratic twice = twice_the_area(motion);
    const Quadratic oriented = (twice.at(0) < 0 ? -1.0 : 1.0) * twice;
    const double room = oriented.least(0, 1) / 2 - least;
    return at_time(room >= 0, oriented.place_of_least(0, 1), room);
}

Finding check_motion_bounds(const Motion& motion, const Requirements& requirements) {
    std::vector<Point> from;
    std::vector<Point> to;
    for (const Moving& asv : motion) {
        from.push_back(asv.from);
        to.push_back(asv.to);
    }
    Finding worst = check_bounds(from, requirements);
    worst.offender.time = 0;
    Finding end = check_bounds(to, requirements);
    end.offender.time = 1;
    keep_worse(worst, std::move(end));
    return worst;
}

}  // namespace asv::core::validation
