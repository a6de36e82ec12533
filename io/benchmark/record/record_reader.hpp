#pragma once

#include <string>
#include <unordered_map>

#include "io/benchmark/report.hpp"
#include "io/text/json/document.hpp"

namespace asv::io {

/// Reads the objects of record_json.hpp back: the plan first, then runs of it, from one document or
/// from several. Of a problem that was run only what tables tell is known: name, file, digest, kind
/// of body and the numbers of ASVs and obstacles; all its coordinates are 0. Everything throws
/// ParseError, also for a run that is not one of the plan's.
class RecordReader {
  public:
    /// Precondition: called once, before the others.
    void read_plan(const JsonDocument& document, std::string_view format);

    BenchmarkSession read_session(const JsonDocument& document,
                                  const JsonDocument::Pointer& at) const;

    core::BenchmarkRun read_run(const JsonDocument& document,
                                const JsonDocument::Pointer& at) const;

    /// Session, problems and planners as they were read; the runs are the caller's to add.
    BenchmarkReport report;

  private:
    std::unordered_map<std::string, std::size_t> problems_, planners_;
};

}  // namespace asv::io
