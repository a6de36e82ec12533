#pragma once

#include <array>

#include "geometry/primitives.hpp"

/// What a broom can be whose heading is in an interval, and the turns between two such brooms.

namespace asv::core {

struct Interval {
    double low = 0;
    double high = 0;
};

inline double width(const Interval& interval) {
    return interval.high - interval.low;
}

struct Direction {
    double sine = 0;
    double cosine = 0;
};

/// The vectors along a broom, from one end to the other, whose heading is in an interval.
struct BroomSector {
    Interval heading;  ///< radians
    Direction first, middle, last;
    bool wide = false;  ///< too wide for its corners to say anything; there are none then
    std::array<geometry::Point, 4> corners;  ///< their hull holds all the vectors
    geometry::Box box;                       ///< and so does this
};

/// shortest, longest: the lengths that the broom may have, 0 < shortest <= longest.
BroomSector broom_sector(const Interval& heading, double shortest, double longest);

/// The sines of all turns from a heading of one broom to one of another.
Interval turn_sines(const BroomSector& from, const BroomSector& to);
Interval turn_cosines(const BroomSector& from, const BroomSector& to);

/// The sine of the turn from one direction to the other.
inline double sine_between(const Direction& from, const Direction& to) {
    return to.sine * from.cosine - to.cosine * from.sine;
}

}  // namespace asv::core
