#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "io/drawing/exhibit.hpp"

/// What a page holds of a long path: a file of a million steps would be too large to be opened.
namespace asv::io {

/// The indices of the states that a page holds, in order: all of them where their number is within
/// the limit. Of a longer path first and last, the worst of each violated requirement, and of each
/// of as many equal stretches as there is room for the first state and those with the least
/// clearance, the least area, the tightest turn and a violation, so that no extreme is lost.
/// Precondition: limit >= 100.
std::vector<std::size_t> held_states(const Exhibit& exhibit, std::size_t limit);

/// The violations in those states: all where their number is within the limit, else those in the
/// worst state of each requirement and of the others an even choice.
std::vector<Violation> held_violations(const Exhibit& exhibit, std::span<const std::size_t> states,
                                       std::size_t limit);

}  // namespace asv::io
