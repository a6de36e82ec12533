#pragma once

#include <boost/multiprecision/cpp_int.hpp>

/// The arithmetic of the checker: every number is a fraction of whole numbers, so that nothing is
/// rounded but roots and pi, which are told from below or from above.

namespace asv::core::certificate_check {

using Number = boost::multiprecision::cpp_rational;

/// Precondition: finite.
inline Number exact(double value) {
    return Number(value);
}

/// The nearest double, for messages.
double rounded(const Number& value);

/// At most 2^-60 less and at most 2^-60 more than the root. Precondition: value >= 0.
Number root_below(const Number& value);
Number root_above(const Number& value);

Number pi_below();
Number pi_above();

/// Down to a whole number. Precondition: value >= 0.
std::size_t whole(const Number& value);

/// Is a number that a certificate states what the checker has found, but for its slack: 1e-9 and
/// 1e-9 of the value? (Certificates come out of double arithmetic.)
bool agrees(double stated, const Number& found);

}  // namespace asv::core::certificate_check
