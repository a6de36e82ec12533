#pragma once

#include <cstdint>
#include <string>

#include "core/model/problem.hpp"

namespace asv::tools {

/// What is known of whether a problem has a path.
struct Solvability {
    enum class Verdict { solvable, infeasible, unknown };
    Verdict verdict = Verdict::unknown;
    std::string reason;
};

/// "solvable", "infeasible" or "unknown".
std::string name(Solvability::Verdict verdict);

/// Whether a problem is certain to have a path or to have none: the conservative check and
/// core::check_feasibility() are asked first and, where they cannot tell, the default planner,
/// whose path counts once the validator's code has passed it, then core::check_passages(). The
/// planner's work is limited by iterations, not by time, so that the answer is the same on every
/// machine. Precondition: that of core::vouch().
Solvability solvability(const core::Problem& problem, std::uint64_t seed);

}  // namespace asv::tools
