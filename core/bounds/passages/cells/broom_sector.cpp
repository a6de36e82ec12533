#include "core/bounds/passages/cells/broom_sector.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/elementary/sine_cosine.hpp"

namespace asv::core {

namespace {

using std::numbers::pi;

/// Sectors of more than twice this angle, radians, are wide.
constexpr double widest_half = 0.7;

/// Is there an angle in the interval that differs from `angle` by a multiple of 2 pi?
bool holds(const Interval& interval, double angle) {
    const auto turns_before = [&](double end) { return std::floor((end - angle) / (2 * pi)); };
    return turns_before(interval.low) != turns_before(interval.high);
}

double cosine_between(const Direction& from, const Direction& to) {
    return to.cosine * from.cosine + to.sine * from.sine;
}

/// All angles from a heading of one to one of the other.
Interval turns(const BroomSector& from, const BroomSector& to) {
    return {to.heading.low - from.heading.high, to.heading.high - from.heading.low};
}

/// The values of a sine or cosine in an interval that has these at its ends, -1 and 1 where `least`
/// and `greatest` are in it.
Interval values(const Interval& angles, double at_low, double at_high, double least,
                double greatest) {
    return {holds(angles, least) ? -1 : std::min(at_low, at_high),
            holds(angles, greatest) ? 1 : std::max(at_low, at_high)};
}

}  // namespace

BroomSector broom_sector(const Interval& heading, double shortest, double longest) {
    const double half = width(heading) / 2;
    const std::array angles{heading.low, heading.low + half, heading.high, half};
    std::array<double, 4> sine, cosine;
    elementary::sine_cosine(angles, sine, cosine);
    BroomSector sector;
    sector.heading = heading;
    sector.first = {sine[0], cosine[0]};
    sector.middle = {sine[1], cosine[1]};
    sector.last = {sine[2], cosine[2]};
    sector.wide = half > widest_half;
    sector.box = {{-longest, -longest}, {longest, longest}};
    if (sector.wide) return sector;
    // The line between the outer corners touches the arc of the longest brooms.
    const double outer = longest / cosine[3] * (1 + 1e-12);
    const auto along = [](double length, const Direction& direction) {
        return geometry::Point{length * direction.cosine, length * direction.sine};
    };
    sector.corners = {along(shortest, sector.first), along(shortest, sector.last),
                      along(outer, sector.first), along(outer, sector.last)};
    sector.box = geometry::bounding_box(sector.corners);
    return sector;
}

Interval turn_sines(const BroomSector& from, const BroomSector& to) {
    return values(turns(from, to), sine_between(from.last, to.first),
                  sine_between(from.first, to.last), -pi / 2, pi / 2);
}

Interval turn_cosines(const BroomSector& from, const BroomSector& to) {
    return values(turns(from, to), cosine_between(from.last, to.first),
                  cosine_between(from.first, to.last), pi, 0);
}

}  // namespace asv::core
