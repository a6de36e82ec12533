#pragma once

#include <chrono>
#include <csignal>
#include <functional>
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

/// Calls that off.
void do_not_end_anyway();

/// Ends the wait of a SignalThread, when nothing has interrupted it.
inline constexpr int wake_up_signal = SIGUSR1;

/// A thread that waits for these signals, since it may do what a signal handler must not; no other
/// thread gets them while it lives. Where the system grants no thread, they end the process.
/// Precondition: made before any other thread, so that all of them leave the signals alone.
class SignalThread {
  public:
    /// Waits once for the signals, of which wake_up_signal only asks to return; called over and
    /// over until a stop is requested.
    using Watch = std::function<void(const std::stop_token&, const sigset_t&)>;

    explicit SignalThread(const Watch& watch);
    ~SignalThread();
    SignalThread(const SignalThread&) = delete;
    SignalThread& operator=(const SignalThread&) = delete;

  private:
    sigset_t set_;
    std::jthread thread_;
};

/// While it lives, these signals ask for a stop instead; a second one ends the process at once with
/// exit code 130. Precondition: that of SignalThread.
class InterruptWatch {
  public:
    InterruptWatch();

    std::stop_token token() const { return interrupted_.get_token(); }

  private:
    std::stop_source interrupted_;
    SignalThread thread_;
};

}  // namespace asv::tools
