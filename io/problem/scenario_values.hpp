#pragma once

#include <cstddef>
#include <limits>
#include <string>

#include "geometry/primitives.hpp"
#include "io/text/json/document.hpp"

/// What all members of a scenario are made of. Each throws ParseError where there is something
/// else.

namespace asv::io {

/// The least number that a length may be: above 0.
inline constexpr double min_positive = std::numeric_limits<double>::min();

/// A joint angle in radians is at most so large: the sum of as many as an arm may have is one whose
/// sine is known.
inline constexpr double largest_angle = 1e6;

/// The elements of the array there; what says in a message what the array should be.
std::size_t array_size(const JsonDocument& document, const JsonDocument::Pointer& at,
                       const std::string& what);

/// A coordinate: any number up to largest_number in size.
double any_number(const JsonDocument& document, const JsonDocument::Pointer& at);

/// [x, y].
geometry::Point read_point(const JsonDocument& document, const JsonDocument::Pointer& at);

}  // namespace asv::io
