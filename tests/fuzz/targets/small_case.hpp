#pragma once

#include <string>
#include <string_view>

#include "core/solve/solve.hpp"

namespace asv::fuzz {

/// What solve() is asked: a small problem, as a scenario that asv-solve reads too, and how.
struct SmallCase {
    std::string scenario;
    core::SolveOptions options;
};

/// Any bytes stand for a case, and near bytes for near cases: a chain of one to six ASVs, an arm or
/// a point, up to five rectangles, some of which touch the start or are hardly there, any planner
/// with a few settings. Its ends are mostly valid. Iterations and work limit the search, no time;
/// one thread.
SmallCase small_case(std::string_view bytes);

}  // namespace asv::fuzz
