#include "tools/mpi/solve/referee.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "tools/bench/runs/run_bytes.hpp"

namespace asv::tools {

namespace {

/// Seconds after the first path in which the others may still find their own, which may lead
/// elsewhere; on easy problems all do, so that it does not matter who was the first.
constexpr double patience = 0.2;
/// Of the time limit, and in seconds: what rank 0 keeps to fetch the best path.
constexpr double share_for_the_end = 0.05, longest_end = 0.5;
/// Seconds for the end of a race that somebody has interrupted.
constexpr double end_of_an_interrupted_race = 0.03;

core::SolveOptions options_of_ranks(core::SolveOptions options) {
    options.time_limit = Referee::limit_of_ranks(options.time_limit);
    return options;
}

}  // namespace

Referee::Referee(Mail& mail, const core::Problem& problem, core::SolveOptions options)
    : mail_(mail),
      problem_(problem),
      options_(std::move(options)),
      runners_(static_cast<std::size_t>(mail.ranks())),
      finishes_(runners_.size()),
      own_(problem, options_of_ranks(options_)) {}

double Referee::limit_of_ranks(double time_limit) {
    return time_limit - std::min(share_for_the_end * time_limit, longest_end);
}

core::SolveResult Referee::run() {
    while (!is_over()) {
        listen();
        look_at_own();
        provide_those_without_a_path();
        if (options_.stop.stop_requested() || time_is_up() || is_decided(finishes_, best_cost_))
            stop();
        mail_.rest();
    }
    return collect();
}

double Referee::elapsed() const {
    return options_.elapsed_before +
           std::chrono::duration<double>(core::Clock::now() - begun_).count();
}

bool Referee::time_is_up() const {
    return elapsed() >= limit_of_ranks(options_.time_limit);
}

void Referee::listen() {
    while (const std::optional<Letter> letter = mail_.receive()) take(*letter);
}

void Referee::take(const Letter& letter) {
    const auto rank = static_cast<std::size_t>(letter.rank);
    if (letter.tag == Tag::found) note_path(letter.rank);
    if (letter.tag == Tag::finish) finishes_[rank] = finish_of(letter.bytes);
    if (letter.tag == Tag::first_path) hand_out(letter.bytes);
    if (letter.tag == Tag::solution) solution_ = path_of(letter.bytes);
    if (letter.tag == Tag::cost) {
        double cost = 0;
        Unpacker{letter.bytes}(cost);
        best_cost_ = std::min(best_cost_, cost);
    }
}

void Referee::look_at_own() {
    if (!runners_[0].found && own_.first_path() != nullptr) note_path(0);
    best_cost_ = std::min(best_cost_, own_.best_cost());
    if (!finishes_[0] && own_.has_ended()) finishes_[0] = own_.finish();
}

void Referee::note_path(int rank) {
    runners_[static_cast<std::size_t>(rank)].found = true;
    if (first_finder_) return;
    first_finder_ = rank;
    found_at_ = elapsed();
    if (rank > 0 && options_.on_path) options_.on_path(found_at_);
}

bool Referee::waits(int rank) const {
    const auto index = static_cast<std::size_t>(rank);
    return !runners_[index].found && !runners_[index].provided && !finishes_[index];
}

void Referee::provide_those_without_a_path() {
    if (!first_finder_ || provided_ || elapsed() < found_at_ + patience) return;
    provided_ = true;
    if (options_.optimize == 0)
        tell_those_who_wait(Tag::stop, {}, [&] { own_.stop(); });
    else if (*first_finder_ == 0)
        hand_out(bytes_of(*own_.first_path()));
    else
        mail_.send(*first_finder_, Tag::give_path);
}

template <class Own>
void Referee::tell_those_who_wait(Tag tag, const std::string& bytes, Own own) {
    for (int rank = 0; rank < mail_.ranks(); ++rank) {
        if (!waits(rank)) continue;
        runners_[static_cast<std::size_t>(rank)].provided = true;
        if (rank == 0)
            own();
        else
            mail_.send(rank, tag, bytes);
    }
}

void Referee::hand_out(const std::string& path) {
    tell_those_who_wait(Tag::go_on_from, path, [&] { own_.go_on_from(path_of(path)); });
}

void Referee::stop() {
    if (end_by_) return;
    end_by_ = options_.stop.stop_requested() ? elapsed() + end_of_an_interrupted_race
                                             : options_.time_limit;
    mail_.send_to_all(Tag::stop);
    // At the end of its time it ends by itself, and tells so.
    if (!time_is_up()) own_.stop();
}

/// All have ended, or there is no time to wait for them.
bool Referee::is_over() const {
    if (!finishes_[0]) return false;
    const bool all = std::all_of(finishes_.begin(), finishes_.end(),
                                 [](const auto& finish) { return finish.has_value(); });
    return all || (end_by_ && elapsed() >= *end_by_);
}

core::SolveResult Referee::collect() {
    core::SolveResult result = own_.result();
    require_no_failure(finishes_);
    winner_ = best_rank(finishes_);
    if (winner_ && *winner_ > 0 && !fetch(*winner_, result)) {
        winner_.reset();
        if (result.solution) winner_ = 0;
    }
    if (!winner_) take_proof(finishes_, result);
    take_statistics(finishes_, result);
    result.statistics.time_total = elapsed();
    return result;
}

/// False where the time is up before the path comes.
bool Referee::fetch(int rank, core::SolveResult& result) {
    mail_.send(rank, Tag::give_solution);
    while (!solution_) {
        if (elapsed() >= options_.time_limit) return false;
        listen();
        mail_.rest();
    }
    take_solution(problem_, std::move(*solution_), *finishes_[static_cast<std::size_t>(rank)],
                  result);
    return true;
}

}  // namespace asv::tools
