#pragma once

#include <cstdint>

#include "core/generate/vouch/vouch.hpp"
#include "core/model/problem.hpp"

namespace asv::tools {

/// Whether a problem is certain to have a path: the conservative check is asked first and, where it
/// cannot tell, the default planner, whose path counts once the validator's code has passed it.
/// The planner's work is limited by iterations, not by time, so that the answer is the same on
/// every machine; it has no way points. Precondition: that of core::vouch().
core::Verdict solvability(const core::Problem& problem, std::uint64_t seed);

}  // namespace asv::tools
