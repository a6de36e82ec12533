#pragma once

#include <cstdint>
#include <string>

#include "core/solve/solve.hpp"
#include "tests/kit/support.hpp"

/// What the tests of solve() share.

namespace asv::core::testing {

/// A problem of testcases/.
Problem testcase(const std::string& file);

/// The first path, with cheap shortcuts only, as on one thread; no test may depend on the time.
SolveOptions plain(std::uint64_t seed);

/// Expects a solution that is valid between its steps too, and figures that are its own.
void expect_solved(const Problem& problem, const SolveResult& result);

}  // namespace asv::core::testing
