#pragma once

#include <string>

namespace asv::geometry {

/// Makes the kernels run on one instruction set from now on, by Highway's name of it (AVX3_ZEN4,
/// AVX2, ...). False when the library or this processor lacks it; then nothing changes.
bool force_simd_target(const std::string& name);

/// The names to choose from, separated by blanks, the best first.
std::string simd_target_names();

/// The one that the kernels run on.
std::string chosen_simd_target();

}  // namespace asv::geometry
