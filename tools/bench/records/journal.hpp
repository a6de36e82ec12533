#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/benchmark/report.hpp"

namespace asv::tools {

/// A file to which every run is added as it ends, and brought to the disk: whatever ends the
/// process or the machine, only the runs at work are lost. The next process with the same plan goes
/// on behind the last whole line.
class Journal {
  public:
    /// Opens the journal, or begins it where there is none. Throws UsageError where it is no
    /// regular file, is of another plan (which tells what differs), or another process writes it,
    /// ParseError where it cannot be understood, ReadError and WriteError.
    Journal(const std::filesystem::path& file, const io::BenchmarkReport& planned);
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    /// The runs that it already holds, and the sessions that they are from.
    const std::vector<core::BenchmarkRun>& runs() const { return runs_; }
    const std::vector<io::BenchmarkSession>& sessions() const { return sessions_; }

    /// Writes down that a session begins: that of the report.
    void begin(const io::BenchmarkReport& report);
    /// A run that has ended, with no fault. Throws WriteError.
    void add(const core::BenchmarkPlan& plan, const core::BenchmarkRun& run);
    /// The session has ended.
    void end(const io::BenchmarkReport& report);

  private:
    void take_over(const std::string& text, const io::BenchmarkReport& planned);
    void append(const std::string& line);
    [[noreturn]] void fail_to_write() const;

    std::filesystem::path file_;
    int descriptor_ = -1;
    bool empty_ = true;
    std::vector<core::BenchmarkRun> runs_;
    std::vector<io::BenchmarkSession> sessions_;
};

}  // namespace asv::tools
