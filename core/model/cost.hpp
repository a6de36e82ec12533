#pragma once

#include <span>

#include "core/model/path.hpp"
#include "core/model/problem.hpp"

namespace asv::core {

/// The sum over all steps and all ASVs of the straight distance moved, workspace units; 0 for fewer
/// than two states. Exact to rounding: compensated summation, so a million steps add up.
double cost(const Path& path);

/// The cost of a path of the problem's body: that, or for an arm the length of the way of its joint
/// angles, radians, each of which takes the short way from state to state.
double cost(const Problem& problem, const Path& path);

/// What one step costs for the problem's body.
double step_cost(const Problem& problem, std::span<const Point> from, std::span<const Point> to);

}  // namespace asv::core
