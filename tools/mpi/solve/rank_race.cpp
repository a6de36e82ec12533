#include "tools/mpi/solve/rank_race.hpp"

#include "io/problem/scenario_text.hpp"
#include "tools/mpi/solve/race_bytes.hpp"
#include "tools/mpi/solve/referee.hpp"

namespace asv::tools {

namespace {

RaceOrder order_for(const SolveArguments& arguments, const core::Problem& problem,
                    const core::SolveOptions& options) {
    return {io::format_scenario(problem),
            arguments.planner,
            arguments.settings,
            options.seed,
            Referee::limit_of_ranks(options.time_limit),
            options.elapsed_before,
            options.optimize,
            options.threads,
            options.reverse};
}

}  // namespace

core::SolveResult RankRace::solve(const SolveArguments& arguments, const core::Problem& problem,
                                  const core::SolveOptions& options) {
    if (!arguments.trees.empty())
        throw UsageError("--trees: under MPI there is no one search whose trees these would be");
    mail_.send_to_all(Tag::order, bytes_of(order_for(arguments, problem, options)));
    Referee referee(mail_, problem, options);
    core::SolveResult result = referee.run();
    if (const auto winner = referee.winner())
        winner_ = std::string("the path of rank ").append(std::to_string(*winner));
    return result;
}

std::string RankRace::summary() const {
    return winner_ + " of " + std::to_string(mail_.ranks()) + " ranks of MPI, by " + mail_.counts();
}

}  // namespace asv::tools
