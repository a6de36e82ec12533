#pragma once

#include <array>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "io/benchmark/report.hpp"

/// The objects that the JSON of a benchmark and its journal are made of (docs/benchmark-files.md);
/// record_reader.hpp reads them.

namespace asv::io {

/// Member "format" of a file that --json has written.
inline constexpr std::string_view runs_format = "asv-bench runs 1";

/// The name of a planner that is another program.
inline constexpr std::string_view external_name = "exec";

/// The words for core::BodyKind, in its order.
inline constexpr std::array<std::string_view, 3> body_names{"chain", "arm", "point"};

/// Format, session, problems and planners.
nlohmann::ordered_json plan_record(const BenchmarkReport& report);

/// The session and the limits of its runs.
nlohmann::ordered_json session_record(const BenchmarkReport& report);

/// One run. Precondition: it is one of the plan's.
nlohmann::ordered_json run_record(const core::BenchmarkPlan& plan, const core::BenchmarkRun& run);

}  // namespace asv::io
