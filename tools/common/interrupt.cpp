#include "tools/common/interrupt.hpp"

#include <cstdlib>
#include <system_error>

#include <pthread.h>
#include <sys/time.h>
#include <unistd.h>

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

sigset_t watched() {
    sigset_t set = interrupting_signals();
    sigaddset(&set, wake_up_signal);
    return set;
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

InterruptWatch::InterruptWatch() {
    const sigset_t set = watched();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    // A thread that waits for the signals may do what a signal handler must not.
    const auto watch = [this, set](const std::stop_token& done) {
        while (!done.stop_requested()) {
            int signal = 0;
            if (sigwait(&set, &signal) != 0 || signal == wake_up_signal) continue;
            if (interrupted_.stop_requested()) std::_Exit(interrupted);
            interrupted_.request_stop();
        }
    };
    try {
        watcher_ = std::jthread(watch);
    } catch (const std::system_error&) {
        // The system grants no thread: the signals then end the process as they do elsewhere.
        pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
    }
}

InterruptWatch::~InterruptWatch() {
    if (watcher_.joinable()) {
        watcher_.request_stop();
        pthread_kill(watcher_.native_handle(), wake_up_signal);
        watcher_.join();
    }
    const sigset_t set = watched();
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

}  // namespace asv::tools
