#pragma once

#include <stop_token>

#include "core/benchmark/run.hpp"

namespace asv::tools {

/// core::run_once() in a process of its own, which begins as a process of asv-solve does: with an
/// empty heap and cold pages. In one process for all runs the later ones find everything warm, and
/// those of a few milliseconds take half the time that a user sees. Fills in the peak memory of the
/// run. A child that ends in any other way than by itself is a fault of the run. abort kills it.
core::BenchmarkRun run_in_child(const core::BenchmarkPlan& plan, const core::RunPlace& place,
                                const std::stop_token& abort);

}  // namespace asv::tools
