#pragma once

#include <string>
#include <vector>

#include "tests/kit/files/run_program.hpp"

/// Programs started by mpirun, on this machine.

namespace asv::test {

/// PROGRAM of the build with so many ranks.
Outcome run_ranks(int ranks, const std::string& program, const std::vector<std::string>& arguments,
                  const Surroundings& surroundings = {});

/// Kills the rank of a program that mpirun has started and in whose arguments there is this word.
/// False where there is none.
bool kill_rank(int rank, const std::string& word);

}  // namespace asv::test
