#pragma once

#include <cstddef>
#include <optional>

namespace asv::io {

/// More ASVs, or links of an arm, than this are refused.
inline constexpr std::size_t max_asvs = 100'000;

/// More obstacles than this are refused, whatever they come from: 32 bytes each as they are read,
/// and about a kilobyte in an index.
inline constexpr std::size_t max_obstacles = 2'000'000;

/// How a problem is read.
struct ReadOptions {
    /// The tolerance at which an obstacle that vanishes is warned about; without it that of the
    /// problem.
    std::optional<double> tolerance = {};
    /// A scenario may name a map outside its own folder.
    bool maps_anywhere = false;
    /// A scenario that has no goal: it may have none, and its goal is its start.
    bool start_only = false;
};

}  // namespace asv::io
