#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace asv::test {

/// The count of a randomised test's cases, times the environment variable ASV_TEST_SCALE where a
/// build is slow (a sanitizer build sets it below 1) or more is wanted; at least 1.
inline std::size_t scaled(std::size_t count) {
    const char* scale = std::getenv("ASV_TEST_SCALE");
    if (scale == nullptr) return count;
    const double share = static_cast<double>(count) * std::atof(scale);
    return std::max<std::size_t>(1, static_cast<std::size_t>(share));
}

}  // namespace asv::test
