#pragma once

#include <vector>

#include "core/model/path.hpp"
#include "core/model/problem.hpp"
#include "tests/kit/chains/chains.hpp"

/// Paths that are written down state by state, for tests of the validator.

namespace asv::test {

/// A problem and a solution of it, whose start, goal and cost agree.
struct Case {
    core::Problem problem;
    core::Solution solution{core::Path(1), 0};
};

core::Path path_of(const std::vector<Points>& states);

/// What all ASVs cover together, summed up anew.
double cost_of(const core::Path& path);

/// A problem and the solution that consists of exactly these states.
Case case_of(const std::vector<Points>& states);

}  // namespace asv::test
