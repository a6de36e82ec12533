#pragma once

#include "asv/core/path/path.hpp"

namespace asv::core {

/// The sum over all steps and all ASVs of the straight distance moved, workspace units; 0 for fewer
/// than two states. Exact to rounding: compensated summation, so a million steps add up.
double cost(const Path& path);

}  // namespace asv::core
