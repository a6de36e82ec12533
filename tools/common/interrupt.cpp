#include "tools/common/interrupt.hpp"

#include <system_error>

#include <pthread.h>
#include <sys/time.h>
#include <unistd.h>

#include "tools/common/end_at_once.hpp"
#include "tools/common/exit_code.hpp"

namespace asv::tools {

namespace {

constexpr int interrupted = static_cast<int>(ExitCode::interrupted);

/// What a handler of signals needs has to be global.
volatile std::sig_atomic_t last_exit_code = interrupted;

void end_process(int /*signal*/) {
    ::_exit(last_exit_code);
}

void handle(int signal) {
    struct sigaction action {};
    action.sa_handler = end_process;
    sigfillset(&action.sa_mask);
    ::sigaction(signal, &action, nullptr);
}

bool ignored(int signal) {
    struct sigaction action {};
    ::sigaction(signal, nullptr, &action);
    return action.sa_handler == SIG_IGN;
}

}  // namespace

sigset_t interrupting_signals() {
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : {SIGINT, SIGTERM}) sigaddset(&set, signal);
    if (!ignored(SIGHUP)) sigaddset(&set, SIGHUP);
    return set;
}

void end_on_interrupt() {
    const sigset_t set = interrupting_signals();
    for (const int signal : {SIGINT, SIGTERM, SIGHUP})
        if (sigismember(&set, signal) == 1) handle(signal);
    // Who started the program may have blocked them.
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

void end_anyway_after(std::chrono::milliseconds time, int exit_code) {
    last_exit_code = exit_code;
    handle(SIGALRM);
    sigset_t alarm;
    sigemptyset(&alarm);
    sigaddset(&alarm, SIGALRM);
    pthread_sigmask(SIG_UNBLOCK, &alarm, nullptr);
    const itimerval once{{0, 0}, {time.count() / 1000, time.count() % 1000 * 1000}};
    ::setitimer(ITIMER_REAL, &once, nullptr);
}

void do_not_end_anyway() {
    const itimerval never{};
    ::setitimer(ITIMER_REAL, &never, nullptr);
}

SignalThread::SignalThread(const Watch& watch) : set_(interrupting_signals()) {
    sigaddset(&set_, wake_up_signal);
    pthread_sigmask(SIG_BLOCK, &set_, nullptr);
    try {
        thread_ = std::jthread([watch, set = set_](const std::stop_token& done) {
            while (!done.stop_requested()) watch(done, set);
        });
    } catch (const std::system_error&) {
        // The system grants no thread: the signals then end the process as they do elsewhere.
        pthread_sigmask(SIG_UNBLOCK, &set_, nullptr);
    }
}

SignalThread::~SignalThread() {
    if (thread_.joinable()) {
        thread_.request_stop();
        pthread_kill(thread_.native_handle(), wake_up_signal);
        thread_.join();
    }
    pthread_sigmask(SIG_UNBLOCK, &set_, nullptr);
}

InterruptWatch::InterruptWatch()
    : thread_([this](const std::stop_token& /*done*/, const sigset_t& signals) {
          int signal = 0;
          if (sigwait(&signals, &signal) != 0 || signal == wake_up_signal) return;
          if (interrupted_.stop_requested()) end_at_once(interrupted);
          interrupted_.request_stop();
      }) {}

}  // namespace asv::tools
