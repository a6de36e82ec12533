#pragma once

#include <array>
#include <string_view>

/// One function for each kind of input that others may have written. Each takes any bytes: an input
/// that is refused as documented is fine, and so is one that is understood and keeps what the
/// headers promise. Where a promise is broken, std::logic_error tells which; any other exception, a
/// crash, a sanitizer's finding, a hang or memory without bound is a finding as well.

namespace asv::fuzz {

void map(std::string_view input);         ///< a map of a scenario: picture or text grid
void problem(std::string_view input);     ///< a problem file
void scenario(std::string_view input);    ///< a scenario beside the maps of testcases/bodies
void settings(std::string_view input);    ///< a planner's name, then lines KEY=VALUE
void solution(std::string_view input);    ///< a problem file, a line "---", a solution file
void solve(std::string_view input);       ///< a small problem and options, see small_case.hpp
void statistics(std::string_view input);  ///< a file of asv-solve --stats
void trajectory(std::string_view input);  ///< a trajectory of two vehicles
void trees(std::string_view input);       ///< a file of asv-solve --trees

/// A kind of input by the name of its folder in tests/fuzz/corpus.
struct Target {
    std::string_view name;
    void (*run)(std::string_view input);
};

inline constexpr std::array targets = {Target{"map", map},
                                       Target{"problem", problem},
                                       Target{"scenario", scenario},
                                       Target{"settings", settings},
                                       Target{"solution", solution},
                                       Target{"solve", solve},
                                       Target{"statistics", statistics},
                                       Target{"trajectory", trajectory},
                                       Target{"trees", trees}};

}  // namespace asv::fuzz
