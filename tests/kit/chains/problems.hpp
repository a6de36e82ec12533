#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "core/model/problem.hpp"
#include "core/search/rng.hpp"
#include "tests/kit/chains/chains.hpp"

namespace asv::test {

using geometry::Box;

/// A problem from one place to another in the unit square.
core::Problem problem(Points start, Points goal, std::vector<Box> obstacles = {});

/// Left and right exchanged, in the unit square.
core::Problem mirrored(core::Problem problem);

/// x and y exchanged.
core::Problem transposed(core::Problem problem);

/// Start and goal exchanged.
core::Problem reversed(core::Problem problem);

/// Random boxes with sides from 0.01 to `size` that do not meet start or goal with some room.
std::vector<Box> clutter(core::Rng& rng, std::size_t count, double size,
                         const core::Problem& around);

/// A ring of n ASVs that shall cross the square among so many such boxes.
core::Problem cluttered(core::Rng& rng, std::size_t n, std::size_t count, double size);

/// The file of a problem of testcases/, as "3ASV.txt".
std::string testcase_file(const std::string& name);

/// A problem of testcases/.
core::Problem testcase(const std::string& name);

}  // namespace asv::test
