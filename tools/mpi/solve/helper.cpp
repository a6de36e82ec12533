#include <chrono>
#include <limits>

#include "core/solve/planner_catalogue.hpp"
#include "io/problem/scenario_file.hpp"
#include "tools/mpi/solve/race_bytes.hpp"
#include "tools/mpi/solve/racer.hpp"
#include "tools/mpi/solve/rank_race.hpp"

namespace asv::tools {

namespace {

core::SolveOptions options_of(const RaceOrder& order, int rank, core::Clock::time_point begun) {
    SolveArguments arguments;
    arguments.planner = order.planner;
    arguments.settings = order.settings;
    core::SolveOptions options;
    options.planner = chosen_planner(arguments);
    options.seed = order.seed;
    options.time_limit = order.time_limit;
    options.optimize = order.optimize;
    options.threads = order.threads;
    options.first_racer = static_cast<std::size_t>(rank) * order.threads;
    options.reverse = order.reverse;
    options.elapsed_before =
        order.elapsed_before + std::chrono::duration<double>(core::Clock::now() - begun).count();
    return options;
}

/// A rank that races: tells rank 0 how far its racer is, and does what that asks for.
class Helper {
  public:
    Helper(Mail& mail, Racer& racer) : mail_(mail), racer_(racer) {}

    /// Until the program ends.
    void run() {
        for (;;) {
            while (const std::optional<Letter> letter = mail_.receive()) {
                if (letter->tag == Tag::end) return;
                obey(*letter);
            }
            tell_news();
            mail_.rest();
        }
    }

  private:
    void obey(const Letter& letter) {
        if (letter.tag == Tag::give_path)
            mail_.send(0, Tag::first_path, bytes_of(*racer_.first_path()));
        else if (letter.tag == Tag::go_on_from)
            racer_.go_on_from(path_of(letter.bytes));
        else if (letter.tag == Tag::stop)
            racer_.stop();
        else if (letter.tag == Tag::give_solution)
            mail_.send(0, Tag::solution, bytes_of(racer_.result().solution->path));
    }

    void tell_news() {
        if (!told_found_ && racer_.first_path() != nullptr) {
            mail_.send(0, Tag::found);
            told_found_ = true;
        }
        if (const double cost = racer_.best_cost(); cost < told_cost_) {
            Packer packer;
            packer(cost);
            mail_.send(0, Tag::cost, packer.bytes());
            told_cost_ = cost;
        }
        if (!told_finish_ && racer_.has_ended()) {
            mail_.send(0, Tag::finish, bytes_of(racer_.finish()));
            told_finish_ = true;
        }
    }

    Mail& mail_;
    Racer& racer_;
    bool told_found_ = false, told_finish_ = false;
    double told_cost_ = std::numeric_limits<double>::infinity();
};

}  // namespace

void help_in_the_race(Mail& mail) {
    const Letter letter = mail.wait();
    if (letter.tag == Tag::order) {
        const auto begun = core::Clock::now();
        const RaceOrder order = order_of(letter.bytes);
        const core::Problem problem =
            io::parse_scenario(order.problem, "the problem of rank 0", {}).problem;
        Racer racer(problem, options_of(order, mail.rank(), begun));
        Helper(mail, racer).run();
    }
    bid_farewell(mail);
}

}  // namespace asv::tools
