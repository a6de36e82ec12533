#include "tools/python/binding/support/watched_solve.hpp"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

namespace asv::python {

namespace {

using core::SolveProgress;
using core::SolveResult;

/// How long Ctrl-C may go unnoticed: nobody feels it, and fifty looks a second cost nothing.
constexpr std::chrono::milliseconds between_looks{20};

/// Where the solving thread leaves news for the one that waits.
class Board {
  public:
    void post(const SolveProgress& progress) {
        const std::lock_guard lock(mutex_);
        news_ = progress;
    }

    void finish() {
        const std::lock_guard lock(mutex_);
        finished_ = true;
        changed_.notify_one();
    }

    /// Waits until the work is finished, or for a look; says whether it is finished.
    bool wait() {
        std::unique_lock lock(mutex_);
        return changed_.wait_for(lock, between_looks, [this] { return finished_; });
    }

    std::optional<SolveProgress> take_news() {
        const std::lock_guard lock(mutex_);
        return std::exchange(news_, std::nullopt);
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::optional<SolveProgress> news_;
    bool finished_ = false;
};

/// One look at what Python wants; says whether to stop. Throws what Python raises.
bool look(Board& board, const py::object& on_progress, const py::object& should_stop) {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    const auto news = board.take_news();
    if (news && !on_progress.is_none()) on_progress(*news);
    return !should_stop.is_none() && should_stop().cast<bool>();
}

}  // namespace

SolveResult solve_watched(const core::Problem& problem, core::SolveOptions options,
                          const py::object& on_progress, const py::object& should_stop) {
    Board board;
    std::stop_source stop;
    options.stop = stop.get_token();
    if (!on_progress.is_none())
        options.on_progress = [&board](const SolveProgress& progress) { board.post(progress); };

    SolveResult result;
    std::exception_ptr failure, raised;
    std::thread worker([&] {
        try {
            result = core::solve(problem, options);
        } catch (...) {
            failure = std::current_exception();
        }
        board.finish();
    });
    const auto finished = [&board] {
        const py::gil_scoped_release release;
        return board.wait();
    };
    while (!finished()) {
        if (raised) continue;
        try {
            if (look(board, on_progress, should_stop)) stop.request_stop();
        } catch (...) {
            raised = std::current_exception();
            stop.request_stop();
        }
    }
    worker.join();
    if (raised) std::rethrow_exception(raised);
    if (failure) std::rethrow_exception(failure);
    return result;
}

}  // namespace asv::python
