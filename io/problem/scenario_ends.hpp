#pragma once

#include <cstddef>
#include <vector>

#include "core/model/body.hpp"
#include "core/model/requirements.hpp"
#include "geometry/primitives.hpp"
#include "io/text/json/document.hpp"

/// Starts and goals of scenarios: as numbers, or by hand as a place, a heading and turns, or as a
/// shape that has a name. docs/scenario.md lists what each may be. All throw ParseError.

namespace asv::io {

/// Is the end of a chain there told as a shape, which does not say how many ASVs there are?
bool is_shape(const JsonDocument& document, const JsonDocument::Pointer& at);

/// The ASVs of a chain: as many as wanted; any number but none where that is 0. Turns are taken as
/// they are; a named shape that would violate a requirement on its shape is refused. Precondition:
/// wanted is not 0 for a shape.
std::vector<geometry::Point> read_chain_end(const JsonDocument& document,
                                            const JsonDocument::Pointer& at, std::size_t wanted,
                                            const core::Requirements& requirements);

/// The joint angles of an arm, radians, within the ranges of its joints.
std::vector<double> read_arm_end(const JsonDocument& document, const JsonDocument::Pointer& at,
                                 const core::PlanarArm& arm);

}  // namespace asv::io
