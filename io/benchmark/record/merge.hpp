#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "io/benchmark/report.hpp"

namespace asv::io {

/// Benchmarks that do not belong together; what() says which and why.
class MergeError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A benchmark and the file that it is from, for messages.
struct NamedReport {
    std::string file;
    BenchmarkReport report;
};

/// One benchmark of several: all their problems, planners, directions and seeds, and all their
/// runs. What has one name in two of them has to be the same there: problems by their digests,
/// planners by their settings. Throws MergeError where that is not so, where limits or versions
/// differ, where two of them have the same run, and where their seeds leave a gap. Precondition: at
/// least one.
BenchmarkReport merged(std::vector<NamedReport> reports);

}  // namespace asv::io
