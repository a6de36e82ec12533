#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

#include "core/solve/solve.hpp"

namespace asv::io {

/// One run of the solver, as --stats reports it.
struct RunStatistics {
    std::string problem;  ///< file name without its folder
    std::size_t asv_count = 0;
    std::size_t obstacle_count = 0;
    std::string planner;
    std::uint64_t seed = 0;
    std::size_t threads = 0;
    core::SolveStatus status = core::SolveStatus::timeout;
    std::string reason;
    core::SolveStatistics spent;
    std::size_t primitive_steps = 0;
    std::size_t peak_memory_bytes = 0;
    std::string version;
};

/// Writes the run as one JSON object: times in seconds, costs in workspace units; what is not known
/// (the cost of an unsolved problem, an infinite bound) is null. Throws WriteError.
void write_statistics(const std::filesystem::path& file, const RunStatistics& run);

}  // namespace asv::io
