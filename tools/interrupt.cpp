#include "asv/tools/interrupt.hpp"

#include <csignal>
#include <ctime>

#include <pthread.h>

namespace asv::tools {

namespace {

sigset_t interrupts() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGINT);
    sigaddset(&set, SIGTERM);
    return set;
}

}  // namespace

InterruptWatch::InterruptWatch() {
    const sigset_t set = interrupts();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
    // A thread that waits for the signals may do what a signal handler must not.
    watcher_ = std::jthread([this](const std::stop_token& done) {
        const sigset_t waited = interrupts();
        const timespec patience{0, 20'000'000};
        while (!done.stop_requested())
            if (sigtimedwait(&waited, nullptr, &patience) > 0)
                (interrupted_.stop_requested() ? again_ : interrupted_).request_stop();
    });
}

InterruptWatch::~InterruptWatch() {
    watcher_ = {};
    const sigset_t set = interrupts();
    pthread_sigmask(SIG_UNBLOCK, &set, nullptr);
}

}  // namespace asv::tools
