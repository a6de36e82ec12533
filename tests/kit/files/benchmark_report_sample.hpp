#pragma once

#include "io/benchmark/report.hpp"

namespace asv::test {

/// Two problems (the name of the second has a blank and a comma), two planners (the label of the
/// second has a bar), both directions, two seeds; planner 2 does not solve problem 1 reversed with
/// seed 4. Every figure is made up and has a short decimal text; the unit is 0.25 s.
io::BenchmarkReport sample_report();

}  // namespace asv::test
