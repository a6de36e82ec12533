#pragma once

#include <string>
#include <vector>

#include "core/certificate/certificate.hpp"

/// The checker of certificates. It shares no code with what finds the proofs, only the problem and
/// the document; it computes with fractions, and takes from a certificate nothing but where to
/// look.

namespace asv::core {

struct CheckedClaim {
    std::string claim;  ///< "corridor 1"
    bool holds = false;
    std::string detail;  ///< what was found
};

struct CertificateVerdict {
    std::vector<CheckedClaim> claims;  ///< at least one

    /// Do all claims hold? Then the validator accepts no path for the problem.
    bool accepted() const;
};

/// Obstacles in one certificate beyond this are refused: each pair of them costs time.
inline constexpr std::size_t most_certified_obstacles = 2000;

/// Checks every number and every claim of the certificate; of one about another problem only that.
/// digest: of the problem, as the certificate should have it. Any certificate is allowed, whatever
/// its numbers, as long as they are finite. The longest work is that for corridors of different
/// heights, for 100 ASVs a second each.
CertificateVerdict check_certificate(const Certificate& certificate, const Problem& problem,
                                     const std::string& digest);

}  // namespace asv::core
