#include "io/problem/thin_walls.hpp"

#include <sstream>

namespace asv::io {

std::optional<std::string> why_it_vanishes(const geometry::Box& obstacle, double tolerance) {
    // The same test as the validator's.
    const geometry::Box left = geometry::grown(obstacle, -tolerance);
    if (!geometry::is_empty(left)) return std::nullopt;
    const bool narrow = left.low.x > left.high.x;
    std::ostringstream text;
    text << "is " << (narrow ? obstacle.high.x - obstacle.low.x : obstacle.high.y - obstacle.low.y)
         << (narrow ? " wide" : " high") << ", less than twice the tolerance of " << tolerance
         << ", and vanishes";
    return text.str();
}

}  // namespace asv::io
