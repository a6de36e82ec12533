#pragma once

#include <optional>

#include "core/certificate/certificate.hpp"
#include "core/model/problem.hpp"

namespace asv::core {

/// The proof that check_feasibility() finds, for others to check: with few of the obstacles, seams
/// and corridors that it could name. None where nothing is proven, or only as the requirements are
/// meant (Infeasibility::separated_as_intended), or by gates, or where so many obstacles are needed
/// that nobody checks them. Costs a second more than the proof at most, since it then drops no more
/// obstacles. Precondition: that of check_feasibility().
std::optional<InfeasibilityProof> certify_infeasibility(const Problem& problem);

}  // namespace asv::core
