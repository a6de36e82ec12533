#pragma once

#include <cstdint>

#include <gtest/gtest.h>

#include "core/solve/solve.hpp"

/// What the tests of solve() share.

namespace asv::test {

/// The first path, with cheap shortcuts only, as on one thread; no test may depend on the time.
core::SolveOptions plain(std::uint64_t seed);

/// Expects a solution that is valid between its steps too, and figures that are its own.
void expect_solved(const core::Problem& problem, const core::SolveResult& result);

}  // namespace asv::test
