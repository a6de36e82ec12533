#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/certificate_check/check_certificate.hpp"
#include "core/certificate_check/limits.hpp"

namespace asv::core::certificate_check {

bool all_hold(const std::vector<CheckedClaim>& claims);

/// The claims that have been looked at so far, and the way to add one.
class Claims {
  public:
    void add(std::string claim, bool holds, std::string detail) {
        claims_.push_back({std::move(claim), holds, std::move(detail)});
    }

    /// A number that the certificate states, against the one that is found here.
    void add_number(const std::string& claim, double stated, const Number& found);

    bool hold() const { return all_hold(claims_); }

    std::vector<CheckedClaim> take() { return std::move(claims_); }

  private:
    std::vector<CheckedClaim> claims_;
};

/// To eight digits.
std::string text_of(const Number& value);

/// What each kind of proof claims.
void check(const AreaProof& proof, const Problem& problem, Claims& claims);
void check(const OrientationProof& proof, const Problem& problem, Claims& claims);
void check(const SeparationProof& proof, const Problem& problem, Claims& claims);
void check(const CorridorProof& proof, const Problem& problem, Claims& claims);

}  // namespace asv::core::certificate_check
