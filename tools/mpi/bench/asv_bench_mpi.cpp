#include <memory>

#include <boost/mpi/environment.hpp>

#include "tools/bench/bench_program.hpp"
#include "tools/common/command_line.hpp"
#include "tools/mpi/bench/rank_crew.hpp"
#include "tools/mpi/mail.hpp"

/// asv-bench whose runs are made by all ranks of MPI. Rank 0 is the program that users know; the
/// others make runs.

int main(int argc, char** argv) try {
    using namespace asv;
    // Before MPI, which starts threads and does not want to be forked.
    const tools::LauncherProcess launcher(tools::serve_told_plan);
    tools::hold_signals_for_rank_0();
    const boost::mpi::environment mpi(argc, argv, boost::mpi::threading::serialized);
    tools::Mail mail;
    const auto jobs = static_cast<std::size_t>(mail.ranks_on_a_machine());
    if (mail.rank() > 0) {
        tools::be_in_the_crew(mail, launcher);
        return 0;
    }
    const auto hire = [&](const core::BenchmarkPlan& plan) {
        return std::make_unique<tools::RankCrew>(mail, launcher, plan);
    };
    const int code = tools::run_bench_program(argc, argv, {hire, jobs});
    tools::dismiss_others(mail);
    return code;
} catch (...) {
    return asv::tools::report_failed_start("asv-bench");
}
