#include <algorithm>
#include <thread>

#include <boost/mpi/environment.hpp>

#include "tools/common/command_line.hpp"
#include "tools/mpi/mail.hpp"
#include "tools/mpi/solve/rank_race.hpp"
#include "tools/solve/solve_program.hpp"

/// asv-solve in which all ranks of MPI race. Rank 0 is the program that users know; the others
/// help.

int main(int argc, char** argv) try {
    using namespace asv;
    tools::hold_signals_for_rank_0();
    const boost::mpi::environment mpi(argc, argv, boost::mpi::threading::funneled);
    tools::Mail mail;
    const auto ranks_here = static_cast<unsigned>(mail.ranks_on_a_machine());
    if (mail.rank() > 0) {
        tools::help_in_the_race(mail);
        return 0;
    }
    tools::RankRace race(mail);
    tools::SolveSite site;
    site.solve = [&](const auto&... task) { return race.solve(task...); };
    site.summary = [&] { return race.summary(); };
    site.alone = false;
    site.threads = std::max(1U, std::thread::hardware_concurrency() / ranks_here);
    const int code = tools::run_solve_program(argc, argv, site);
    tools::dismiss_others(mail);
    return code;
} catch (...) {
    return asv::tools::report_failed_start("asv-solve");
}
