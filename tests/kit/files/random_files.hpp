#pragma once

#include <cstddef>
#include <vector>

#include "core/model/path.hpp"
#include "core/model/problem.hpp"
#include "tests/kit/chains/chains.hpp"
#include "tests/kit/random.hpp"

/// Random values that a file can hold; they mean nothing to a planner.

namespace asv::test {

/// Half of them in [0, 1), half with any bits that give a number a file may hold.
double random_number(Random& random);

Points random_points(Random& random, std::size_t count);

core::Problem random_problem(Random& random);

core::Solution random_solution(Random& random, std::size_t asv_count);

}  // namespace asv::test
