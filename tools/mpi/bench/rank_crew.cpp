#include "tools/mpi/bench/rank_crew.hpp"

#include <numeric>

#include "tools/bench/runs/run_bytes.hpp"
#include "tools/common/mpi_launch.hpp"
#include "tools/mpi/bench/plan_bytes.hpp"

namespace asv::tools {

RankCrew::RankCrew(Mail& mail, const LauncherProcess& own, const core::BenchmarkPlan& plan)
    : mail_(mail), own_(own), idle_(size()), desks_(size()) {
    std::iota(idle_.rbegin(), idle_.rend(), 0);
    const std::string bytes = plan_bytes(plan);
    mail_.send_to_all(Tag::plan, bytes);
    own_.tell(bytes);
    // The postman must not get them. Who hires a crew has a thread for them next.
    hold_signals_for_rank_0();
    if (size() > 1)
        postman_ = std::jthread([this](const std::stop_token& done) { be_postman(done); });
}

int RankCrew::take_idle_rank() {
    const std::lock_guard lock(mutex_);
    const int rank = idle_.back();
    idle_.pop_back();
    return rank;
}

core::BenchmarkRun RankCrew::run(const core::RunPlace& place, const std::stop_token& abort) {
    const int rank = take_idle_rank();
    const std::string question = place_bytes(place);
    const std::optional<std::string> answer =
        rank == 0 ? own_.ask(question, [&] { return abort.stop_requested(); })
                  : ask(rank, question, abort);
    core::BenchmarkRun run;
    run.place = place;
    if (answer || !abort.stop_requested()) run = answered_run(answer, place);
    const std::lock_guard lock(mutex_);
    idle_.push_back(rank);
    ++runs_;
    return run;
}

std::optional<std::string> RankCrew::ask(int rank, const std::string& place,
                                         const std::stop_token& abort) {
    std::unique_lock lock(mutex_);
    to_post_.emplace_back(rank, place);
    Desk& desk = desks_[static_cast<std::size_t>(rank)];
    desk.has_come.wait(lock, abort, [&] { return desk.answer.has_value(); });
    return std::exchange(desk.answer, std::nullopt);
}

void RankCrew::be_postman(const std::stop_token& done) {
    while (!done.stop_requested()) {
        post();
        if (std::optional<Letter> letter = mail_.receive())
            hand_out(std::move(*letter));
        else
            mail_.rest();
    }
}

void RankCrew::post() {
    const std::lock_guard lock(mutex_);
    for (; !to_post_.empty(); to_post_.pop_front())
        mail_.send(to_post_.front().first, Tag::place, std::move(to_post_.front().second));
}

void RankCrew::hand_out(Letter letter) {
    const std::lock_guard lock(mutex_);
    Desk& desk = desks_[static_cast<std::size_t>(letter.rank)];
    desk.answer = std::move(letter.bytes);
    desk.has_come.notify_one();
}

std::string RankCrew::summary() const {
    return std::to_string(runs_) + " runs on " + std::to_string(size()) + " ranks of MPI, by " +
           mail_.counts();
}

void serve_told_plan(int socket) {
    // A run may be another program, which must not take itself for a rank.
    forget_mpi_launch();
    const std::optional<std::string> plan = read_block(socket);
    if (plan) serve_runs(plan_of(*plan), socket);
}

void be_in_the_crew(Mail& mail, const LauncherProcess& launcher) {
    for (Letter letter = mail.wait(); letter.tag != Tag::end; letter = mail.wait()) {
        if (letter.tag == Tag::plan) {
            launcher.tell(letter.bytes);
            continue;
        }
        // All that may come during a run is that nobody waits for it any more.
        const auto answer = launcher.ask(letter.bytes, [&] { return mail.has_come(); });
        const bool wanted = !mail.has_come();
        if (answer)
            mail.send(0, Tag::run, *answer);
        else if (wanted)
            mail.send(0, Tag::run, run_bytes(answered_run(answer, {})));
    }
    bid_farewell(mail);
}

}  // namespace asv::tools
