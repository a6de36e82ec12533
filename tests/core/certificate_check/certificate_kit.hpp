#pragma once

#include <string>
#include <vector>

#include "core/certificate_check/check_certificate.hpp"

namespace asv::test {

/// The verdict on a proof that is about this problem.
core::CertificateVerdict check(const core::InfeasibilityProof& proof, const core::Problem& problem);

/// The names of the claims that do not hold, with commas.
std::string failures(const core::CertificateVerdict& verdict);

/// All obstacles of the problem.
std::vector<std::size_t> all_obstacles(const core::Problem& problem);

/// The seam between two walls, with the numbers that it has.
core::ClosedSeam seam(const core::Problem& problem, const core::FacingWalls& facing);

/// The corridor between two walls, with the numbers that it has.
core::ClosedCorridor corridor(const core::Problem& problem, const core::FacingWalls& facing);

/// A proof by corridors, with all obstacles.
core::CorridorProof corridor_proof(const core::Problem& problem,
                                   std::vector<core::ClosedCorridor> corridors);

/// All that is between two obstacles, or one and the border, and is longer than the chain.
std::vector<core::ClosedCorridor> all_corridors(const core::Problem& problem);

}  // namespace asv::test
