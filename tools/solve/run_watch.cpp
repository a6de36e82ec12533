#include "tools/solve/run_watch.hpp"

#include <algorithm>
#include <csignal>
#include <ctime>
#include <fstream>
#include <utility>

#include "tools/common/end_at_once.hpp"

namespace asv::tools {

namespace {

using core::Clock;
using std::chrono::milliseconds;

/// What a run that was asked to stop gets to write its best path: so much of processors, and on a
/// machine that is busy elsewhere so much of wall clock. One that waits for a reader, or has no
/// path, gets the former of wall clock.
constexpr milliseconds patience{70}, patience_of_a_busy_machine{250};
/// Between two looks at what it has used.
constexpr milliseconds between_looks{5};
/// So long before the limit it begins to look at how long the end will take.
constexpr milliseconds look_ahead{100};

timespec time_until(Clock::time_point moment) {
    const auto left = std::clamp(moment - Clock::now(), Clock::duration::zero(),
                                 Clock::duration(std::chrono::hours(24)));
    const auto whole = std::chrono::duration_cast<std::chrono::seconds>(left);
    return {whole.count(), std::chrono::nanoseconds(left - whole).count()};
}

/// What the system takes to end the process: it has to give back its memory.
Clock::duration time_to_end() {
    std::size_t total_pages = 0, pages = 0;
    std::ifstream("/proc/self/statm") >> total_pages >> pages;
    constexpr double nanoseconds_per_page = 500;
    return milliseconds(1) + std::chrono::nanoseconds(static_cast<std::int64_t>(
                                 nanoseconds_per_page * static_cast<double>(pages)));
}

}  // namespace

double processor_seconds() {
    timespec used{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

RunWatch::RunWatch(std::optional<Clock::time_point> limit,
                   std::function<int(const CutOff&)> give_up)
    : limit_(limit),
      give_up_(std::move(give_up)),
      thread_(
          [this](const std::stop_token& done, const sigset_t& signals) { watch(done, signals); }) {}

void RunWatch::enter(Stage stage, bool to_stream) {
    to_stream_ = to_stream;
    stage_ = stage;
}

void RunWatch::watch(const std::stop_token& done, const sigset_t& signals) {
    const timespec wait = time_until(next_look());
    const int signal = ::sigtimedwait(&signals, nullptr, &wait);
    if (done.stop_requested()) return;
    if (signal > 0 && signal != wake_up_signal) take_signal();
    if (interrupted_.stop_requested() && patience_is_over()) cut_off(true);
    if (limit_ && Clock::now() >= *limit_ - time_to_end()) cut_off(false);
}

Clock::time_point RunWatch::next_look() const {
    const Clock::time_point now = Clock::now();
    Clock::time_point next = Clock::time_point::max();
    const bool limit_is_near = limit_ && *limit_ - now <= look_ahead;
    if (limit_) next = *limit_ - (limit_is_near ? time_to_end() : look_ahead);
    // Memory may grow until then.
    if (limit_is_near || interrupted_.stop_requested()) next = std::min(next, now + between_looks);
    return next;
}

void RunWatch::take_signal() {
    if (interrupted_.stop_requested() || stage_ == Stage::reading) cut_off(true);
    interrupted_at_ = Clock::now();
    used_then_ = processor_seconds();
    interrupted_.request_stop();
}

bool RunWatch::patience_is_over() const {
    const Clock::duration waited = Clock::now() - interrupted_at_;
    const bool path_is_coming = path_after_ >= 0 && !to_stream_;
    if (!path_is_coming) return waited >= patience;
    const std::chrono::duration<double> used(processor_seconds() - used_then_);
    return used >= patience || waited >= patience_of_a_busy_machine;
}

void RunWatch::cut_off(bool interrupted) const {
    CutOff at{interrupted, stage_, to_stream_, std::nullopt};
    const double path_after = path_after_;
    if (path_after >= 0) at.path_after = path_after;
    end_at_once(give_up_(at));
}

}  // namespace asv::tools
