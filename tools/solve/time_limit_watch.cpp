#include "tools/solve/time_limit_watch.hpp"

#include <condition_variable>
#include <csignal>
#include <mutex>
#include <stop_token>
#include <utility>

#include <pthread.h>

namespace asv::tools {

TimeLimitWatch::TimeLimitWatch(std::chrono::steady_clock::time_point moment,
                               std::function<void()> give_up) {
    // Signals are for the threads that know what to do with them; a new thread inherits the mask.
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    watcher_ = std::jthread([moment, act = std::move(give_up)](const std::stop_token& done) {
        std::mutex mutex;
        std::condition_variable_any never;
        std::unique_lock lock(mutex);
        never.wait_until(lock, done, moment, [] { return false; });
        if (!done.stop_requested()) act();
    });
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

}  // namespace asv::tools
