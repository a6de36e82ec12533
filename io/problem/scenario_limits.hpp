#pragma once

#include <cstddef>

#include "core/model/motion_limits.hpp"
#include "io/text/json/document.hpp"

namespace asv::io {

/// Reads the member "limits" of a scenario: "speed" and "acceleration", each of which may be absent
/// and is a number or an array with one for each of so many vehicles. Throws ParseError.
core::MotionLimits read_motion_limits(const JsonDocument& document, const JsonDocument::Pointer& at,
                                      std::size_t vehicles);

}  // namespace asv::io
