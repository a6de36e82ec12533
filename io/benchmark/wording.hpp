#pragma once

#include <cstddef>
#include <string>

#include "core/benchmark/plan.hpp"
#include "io/benchmark/report.hpp"

/// Phrases that several outputs of a benchmark share.

namespace asv::io {

/// "1 obstacle", "2 obstacles".
std::string plural(std::size_t count, const std::string& noun);

/// "7 ASVs, 7 obstacles; no path costs less than 6.297"; a lower bound of 0 is not known.
std::string problem_facts(const core::Problem& problem, double lower_bound);

/// "Seeds 1 to 10, time limit 10 s, optimize 0 s, 1 thread".
std::string plan_facts(const core::BenchmarkPlan& plan);

/// "3 runs side by side: their times are spoilt."; empty where each run had the machine to itself.
std::string spoilt_note(const core::BenchmarkPlan& plan);

/// " Runs of 2 sessions.", and what that means for their times where machines differ; empty for
/// runs of one session.
std::string sessions_note(const BenchmarkSession& session);

}  // namespace asv::io
