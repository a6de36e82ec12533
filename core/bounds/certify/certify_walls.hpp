#pragma once

#include <cstddef>
#include <optional>

#include "core/certificate/certificate.hpp"
#include "core/model/problem.hpp"

namespace asv::core {

/// That obstacles separate the start of this ASV from its goal, or where seams are needed that of
/// one in the middle of the chain. None where too many obstacles are needed.
/// Precondition: check_separation() says `separated`; the problem has bounds.
std::optional<InfeasibilityProof> certify_separation(const Problem& problem, std::size_t asv);

/// That the middle of the chain has to pass corridors that are too low. None where too many
/// obstacles are needed. Precondition: check_separation() says `corridor_too_low`; the problem has
/// bounds.
std::optional<InfeasibilityProof> certify_corridors(const Problem& problem);

}  // namespace asv::core
