#pragma once

#include <vector>

#include "io/benchmark/plot/curve_data.hpp"

namespace asv::io {

/// Two panels over the parameter of the report (core/benchmark/parameter_curves.hpp): the median
/// time to the first path, as far as it is within the time limit, and the share of runs solved,
/// each with its confidence interval as a band.
std::vector<CurvePanel> parameter_panels(const BenchmarkReport& report);

}  // namespace asv::io
