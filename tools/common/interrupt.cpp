#include "tools/common/interrupt.hpp"

#include <csignal>

#include <pthread.h>

namespace asv::tools {

namespace {

/// Ends the watcher's wait when nothing has interrupted it.
constexpr int wake_up = SIGUSR1;

sigset_t watched() {
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : {SIGINT, SIGTERM, wake_up}) sigaddset(&set, signal);
    return set;
}

}  // namespace

InterruptWatch::InterruptWatch() {
    const sigset_t set = watched();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    // A thread that waits for the signals may do what a signal handler must not.
    watcher_ = std::jthread([this, set](const std::stop_token& done) {
        while (!done.stop_requested()) {
            int signal = 0;
            if (sigwait(&set, &signal) == 0 && signal != wake_up)
                (interrupted_.stop_requested() ? again_ : interrupted_).request_stop();
        }
    });
}

InterruptWatch::~InterruptWatch() {
    watcher_.request_stop();
    pthread_kill(watcher_.native_handle(), wake_up);
    watcher_.join();
    const sigset_t set = watched();
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

}  // namespace asv::tools
