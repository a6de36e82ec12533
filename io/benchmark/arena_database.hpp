#pragma once

#include <string>

#include "io/benchmark/report.hpp"

namespace asv::io {

/// The bytes of an SQLite database as Planner Arena (plannerarena.org) wants it: the tables
/// experiments, plannerConfigs, enums, runs and progress, with the columns that OMPL's
/// ompl_benchmark_statistics.py makes of its logs. An experiment is a problem in one direction.
std::string arena_database(const BenchmarkReport& report);

}  // namespace asv::io
