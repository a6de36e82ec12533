#pragma once

#include "core/model/problem.hpp"

/// What the requirements leave to the chain of a problem, tolerance included.

namespace asv::core {

/// The length of a chain of the longest brooms.
double longest_chain(const Problem& problem);

/// The least area.
double least_area(const Problem& problem);

/// Is it proven that no path leads from a chain that turns left to one that turns right?
/// Precondition: a chain of at least two ASVs.
bool keeps_orientation(const Problem& problem);

}  // namespace asv::core
