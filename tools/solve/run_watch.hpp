#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <stop_token>

#include "core/search/limits.hpp"
#include "tools/common/interrupt.hpp"

namespace asv::tools {

/// What asv-solve is at.
enum class Stage {
    reading,
    solving,
    writing_solution,
    writing_statistics,
    writing_certificate,
    writing_trajectory,
    writing_trees
};

/// Why a run is cut off, and what it was at.
struct CutOff {
    bool interrupted = false;  ///< by a signal, else by the time limit
    Stage stage = Stage::reading;
    bool to_stream = false;            ///< writes to a pipe or a device, which somebody must read
    std::optional<double> path_after;  ///< seconds after which there was a path
};

/// Ends a run that does not end by itself: at the time limit, or soon after INT, TERM or HUP has
/// asked for a stop; at once when one comes a second time, or when nothing has been begun yet.
/// Reading a file, indexing obstacles or waiting for the reader of an output cannot be asked to
/// stop, so that the process is ended from a thread of its own.
class RunWatch {
  public:
    /// give_up tells the user and returns the exit code; it is called from the watching thread and
    /// gets a few milliseconds. Precondition: that of SignalThread. Without a limit only signals
    /// are watched for; where the system grants no thread the solver alone keeps the limit.
    RunWatch(std::optional<core::Clock::time_point> limit,
             std::function<int(const CutOff&)> give_up);

    /// Asks for a stop once a signal has come.
    std::stop_token interrupted() const { return interrupted_.get_token(); }

    void enter(Stage stage, bool to_stream = false);
    void note_path(double seconds) { path_after_ = seconds; }

  private:
    void watch(const std::stop_token& done, const sigset_t& signals);
    /// The next moment at which something has to be looked at.
    core::Clock::time_point next_look() const;
    bool patience_is_over() const;
    void take_signal();
    void cut_off(bool interrupted) const;

    std::optional<core::Clock::time_point> limit_;
    std::function<int(const CutOff&)> give_up_;
    std::stop_source interrupted_;
    core::Clock::time_point interrupted_at_{};
    double used_then_ = 0;  ///< seconds of processors, when the signal came
    std::atomic<Stage> stage_ = Stage::reading;
    std::atomic<bool> to_stream_ = false;
    std::atomic<double> path_after_ = -1;
    SignalThread thread_;
};

/// Seconds of processors that the process has used.
double processor_seconds();

}  // namespace asv::tools
