#pragma once

#include <chrono>
#include <csignal>
#include <stop_token>
#include <thread>

namespace asv::tools {

/// INT, TERM and HUP. A hangup that the process was told to ignore (nohup) is left out; the others
/// count even so, since shells ignore an interrupt for jobs in the background.
sigset_t interrupting_signals();

/// From here on these signals end the process with exit code 130, whatever it is doing: files are
/// written whole or not at all, so nothing else is to be done.
void end_on_interrupt();

/// Ends the process with this exit code once so much time has passed, whatever it is doing then,
/// waiting for somebody to read its output included. For the thread that calls it, and that may
/// not outlast this either.
void end_anyway_after(std::chrono::milliseconds time, int exit_code);

/// While it lives, these signals ask for a stop instead; a second one ends the process at once with
/// exit code 130. Precondition: made before any other thread, so that all of them leave the signals
/// alone.
class InterruptWatch {
  public:
    InterruptWatch();
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;

    std::stop_token token() const { return interrupted_.get_token(); }

  private:
    std::stop_source interrupted_;
    std::jthread watcher_;
};

/// Ends the wait of a thread for signals, when nothing has interrupted it: for watches alone.
inline constexpr int wake_up_signal = SIGUSR1;

}  // namespace asv::tools
