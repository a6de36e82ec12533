#pragma once

#include <cstddef>
#include <string>

#include "core/solve/solve_result.hpp"
#include "io/solution/trees_file.hpp"

namespace asv::python {

/// What the planner of that name has explored, as files and pictures have it.
io::SearchTrees trees_of(const core::SolveResult& result, const std::string& planner,
                         std::size_t asv_count);

}  // namespace asv::python
