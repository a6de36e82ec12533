#pragma once

#include <span>

namespace asv::elementary {

/// sine[i] and cosine[i] of angle[i], radians, to within 2e-16 for |angle| < 1e5. The same bits
/// on every machine, unlike libm, and many angles at a time where the processor can.
/// Precondition: the spans have one length.
void sine_cosine(std::span<const double> angle, std::span<double> sine, std::span<double> cosine);

}  // namespace asv::elementary
