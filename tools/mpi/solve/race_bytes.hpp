#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/model/path.hpp"
#include "core/solve/solve_result.hpp"
#include "tools/bench/runs/run_bytes.hpp"

/// What ranks that race tell each other, as bytes.

namespace asv::tools {

/// What each rank is to solve.
struct RaceOrder {
    std::string problem;                ///< as a scenario
    std::string planner;                ///< its name
    std::vector<std::string> settings;  ///< "KEY=VALUE"
    std::uint64_t seed = 1;
    double time_limit = 0;      ///< seconds, for the ranks; rank 0 keeps some for the end
    double elapsed_before = 0;  ///< seconds of it that have passed
    double optimize = 0;        ///< seconds of work
    std::size_t threads = 1;    ///< of each rank
    bool reverse = false;
};

/// How solving ended on a rank.
struct RaceFinish {
    core::SolveStatus status = core::SolveStatus::timeout;
    std::string reason;
    std::string failure;  ///< a bug, or no memory: what was thrown
    core::SolveStatistics spent;
};

std::string bytes_of(const RaceOrder& order);
std::string bytes_of(const RaceFinish& finish);
std::string bytes_of(const core::Path& path);

RaceOrder order_of(std::string_view bytes);
RaceFinish finish_of(std::string_view bytes);
core::Path path_of(std::string_view bytes);

}  // namespace asv::tools
