#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <gtest/gtest.h>

#include "core/search/rng.hpp"

namespace asv::test {

/// Calls body(rng) for the seeds 1, 2, ..., count. A failure names its seed and ends the loop.
template <class Body>
void for_seeds(std::size_t count, Body&& body) {
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        core::Rng rng(seed);
        body(rng);
        if (::testing::Test::HasFailure()) return;
    }
}

}  // namespace asv::test
