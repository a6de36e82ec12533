#pragma once

#include <optional>
#include <string>

#include "core/model/problem.hpp"

namespace asv::io {

/// The longest primitive step that a scenario may set for its body: the shortest link of an arm,
/// since links that turn far in one step could not be told from links that turn the other way.
double largest_step(const core::Problem& problem);

/// Where the goal is more than 100,000 primitive steps away, words for a warning, with the step
/// that would fit: such paths take long, and nobody knows why.
std::optional<std::string> why_so_many_steps(const core::Problem& problem);

}  // namespace asv::io
