#include "core/solve/stages/in_threads.hpp"

#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace asv::core {

namespace {

/// The work of all threads, and what the first of them to fail has thrown.
class SharedWork {
  public:
    SharedWork(std::stop_source stop, const std::function<void(std::size_t)>& work)
        : stop_(std::move(stop)), work_(work) {}

    bool stopped() const { return stop_.stop_requested(); }

    /// Calls action(); keeps what it throws, which must not leave a thread.
    template <class Action>
    void guarded(Action action) noexcept {
        try {
            action();
        } catch (...) {
            keep(std::current_exception());
        }
    }

    void run(std::size_t thread) noexcept {
        guarded([&] { work_(thread); });
    }

    void rethrow() const {
        if (failure_) std::rethrow_exception(failure_);
    }

  private:
    void keep(std::exception_ptr failure) noexcept {
        {
            const std::lock_guard lock(mutex_);
            if (!failure_) failure_ = std::move(failure);
        }
        stop_.request_stop();
    }

    std::stop_source stop_;
    const std::function<void(std::size_t)>& work_;
    std::mutex mutex_;
    std::exception_ptr failure_;
};

}  // namespace

void in_threads(std::size_t count, std::stop_source stop,
                const std::function<void(std::size_t)>& work) {
    SharedWork shared(std::move(stop), work);
    {
        std::vector<std::jthread> others;
        shared.guarded([&] {
            for (std::size_t thread = 1; thread < count && !shared.stopped(); ++thread) try {
                    others.emplace_back([&shared, thread] { shared.run(thread); });
                } catch (const std::system_error&) {
                    return;  // the system grants no more
                }
        });
        shared.run(0);
    }
    shared.rethrow();
}

}  // namespace asv::core
