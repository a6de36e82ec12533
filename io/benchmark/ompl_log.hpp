#pragma once

#include <filesystem>
#include <string>

#include "io/benchmark/experiment.hpp"
#include "io/benchmark/report.hpp"

namespace asv::io {

/// One experiment as a text log of OMPL's benchmarks, which ompl_benchmark_statistics.py reads. The
/// costs of each run over time are its progress property `best cost`.
std::string ompl_log(const BenchmarkReport& report, const Experiment& experiment);

/// A log holds one experiment: with several, the name of each is put before the ending
/// ("bench.log": "bench-7ASV-reversed.log"). Characters that part folders become '_'.
std::filesystem::path ompl_log_file(const std::filesystem::path& file, const Experiment& experiment,
                                    bool several);

}  // namespace asv::io
