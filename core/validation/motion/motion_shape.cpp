#include "core/validation/motion/motion_shape.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "geometry/elementary/functions.hpp"

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

/// Of a turn the shorter way from direction u to v, which is less than pi: 1 where it passes the
/// positive x axis counter-clockwise, -1 clockwise, 0 where it does not. Summed over a closed
/// polygon these are its full turns.
int passes_axis(const Point& u, const Point& v) {
    if ((u.y < 0) == (v.y < 0)) return 0;
    const double cross = u.x * v.y - u.y * v.x;
    return u.y < 0 ? (cross > 0 ? 1 : 0) : (cross < 0 ? -1 : 0);
}

/// One turn over time, from side u to side v.
struct Joint {
    Finding finding;
    bool never_against = false;  ///< proven to turn with the orientation, or not at all
};

/// Checks turns with an orientation and a tolerance, both for all joints of a motion.
///
/// With a = sign * turn, cross * cos(e) * sign + dot * sin(e) is |u| |v| sin(a + e). Where it is
/// not negative, a is in [-e, pi - e]. That refuses turns within e of pi, which come with next to
/// no area, and needs no more than a quadratic.
class JointCheck {
  public:
    JointCheck(double sign, double e)
        : sign_(sign), e_(e), cosine_(elementary::cos(e)), sine_(elementary::sin(e)) {}

    Joint operator()(const Moving& u, const Moving& v, double radius) const {
        const Quadratic turning = sign_ * cross(u, v);
        const Quadratic rotated = cosine_ * turning + sine_ * dot(u, v);
        const double time = rotated.place_of_least(0, 1);
        const double least = rotated.at(time) - rotated.error;
        Joint joint;
        joint.never_against = turning.least(0, 1) >= 0;
        const bool ok = least >= 0;
        if (ok && leaves_more(radius, least, u.at(time), v.at(time))) return joint;
        double room = room_at(time, u, v);
        // A proof that fails within rounding leaves no room, whatever the angle looks like.
        if (!ok) room = std::min(room, -std::numeric_limits<double>::epsilon());
        joint.finding = at_time(ok, time, room);
        return joint;
    }

  private:
    double room_at(double time, const Moving& u, const Moving& v) const {
        const Point a = u.at(time), b = v.at(time);
        const double angle =
            sign_ * elementary::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
        return std::min(angle + e_, pi - e_ - angle);
    }

    /// Room is the least of a + e and pi - a - e, so never less than sin(a + e), which is `least`
    /// over the lengths of both sides.
    static bool leaves_more(double radius, double least, const Point& a, const Point& b) {
        constexpr double rounded_up = 1.000001;
        const double squares = (a.x * a.x + a.y * a.y) * (b.x * b.x + b.y * b.y);
        const double radius_or_none = std::max(radius, 0.0);
        return least * least > rounded_up * squares * radius_or_none * radius_or_none;
    }

    double sign_, e_, cosine_, sine_;
};

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
        const auto note = [&](bool ok, const Quadratic& least_where, double room) {
            if (!worse(ok, room, worst)) return;
            worst = at_time(ok, least_where.place_of_least(0, 1), room);
            worst.offender.broom = i;
        };
        const Quadratic squared = dot(side(motion, i), side(motion, i));
        const Quadratic negated = -1.0 * squared;
        const double low = squared.least(0, 1);
        const double high = -negated.least(0, 1);
        note(shortest <= 0 || low >= shortest * shortest, squared,
             std::sqrt(std::max(low, 0.0)) - shortest);
        note(high <= longest * longest, negated, longest - std::sqrt(high));
    }
    return worst;
}

// As long as no side is a point and no turn reaches pi, turns change continuously, and so does
// their sum, which for a closed polygon is a multiple of 2 pi: it keeps its value at time 0. The
// sum of their sizes exceeds it by twice those that go against the orientation, by e at most.
Finding check_motion_convexity(const Motion& motion, const Requirements& requirements,
                               double radius) {
    const std::size_t n = motion.size();
    if (n < 2) return {};
    // Beyond a right angle the sine above says nothing more; a smaller tolerance is stricter.
    const double e = std::min(requirements.tolerance, 1.0);
    const double sign = twice_the_area(motion).at(0) < 0 ? -1 : 1;
    // Turns at a side that is a point mean nothing, so this comes first.
    if (std::optional<Finding> point = vanishing_side(motion)) return *point;
    const JointCheck check_joint(sign, e);
    int full_turns = 0;
    double against = 0;
    Finding worst;
    Moving last = side(motion, n - 1);
    for (std::size_t i = 0; i < n; ++i) {
        const Moving next = side(motion, i);
        Joint joint = check_joint(last, next, std::min(radius, worst.offender.room));
        joint.finding.offender.asv = i;
        full_turns += passes_axis(last.from, next.from);
        if (!joint.never_against) against += 2 * e;
        keep_worse(worst, std::move(joint.finding));
        last = next;
    }
    const double turns = sign * full_turns;
    const double room = 3 * pi - (2 * pi * turns + against);
    keep_worse(worst, at_time(room >= 0 && turns >= 1, 0, room));
    return worst;
}

Finding check_motion_area(const Motion& motion, const Requirements& requirements) {
    const double least = requirements.min_area(motion.size()) - requirements.tolerance;
    const Quadratic twice = twice_the_area(motion);
    const Quadratic oriented = (twice.at(0) < 0 ? -1.0 : 1.0) * twice;
    const double room = oriented.least(0, 1) / 2 - least;
    return at_time(room >= 0, oriented.place_of_least(0, 1), room);
}

Finding check_motion_bounds(State from, State to, const Requirements& requirements) {
    Finding worst = check_bounds(from, requirements);
    worst.offender.time = 0;
    Finding end = check_bounds(to, requirements);
    end.offender.time = 1;
    keep_worse(worst, std::move(end));
    return worst;
}

}  // namespace asv::core::validation
