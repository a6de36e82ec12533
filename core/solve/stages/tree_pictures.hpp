#pragma once

#include <vector>

#include "core/search/search_result.hpp"
#include "core/solve/stages/solve_call.hpp"

namespace asv::core {

/// The trees of a search in the coordinates of the given problem, that of the start first.
std::vector<TreePicture> draw_trees(const SearchResult& search, const SolveCall& call);

}  // namespace asv::core
