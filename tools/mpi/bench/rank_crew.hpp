#pragma once

#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "tools/bench/runs/launcher_process.hpp"
#include "tools/bench/runs/run_crew.hpp"
#include "tools/mpi/mail.hpp"

namespace asv::tools {

/// All ranks of MPI, rank 0 among them; each makes one run at a time, in a process of its own, and
/// gets the next one when it has ended.
class RankCrew : public RunCrew {
  public:
    /// For rank 0: tells the others the plan. `own` is the launcher process of rank 0, which serves
    /// serve_told_plan(). Precondition: mail and launcher outlive this, and nobody else uses them
    /// meanwhile.
    RankCrew(Mail& mail, const LauncherProcess& own, const core::BenchmarkPlan& plan);

    std::size_t size() const override { return static_cast<std::size_t>(mail_.ranks()); }
    core::BenchmarkRun run(const core::RunPlace& place, const std::stop_token& abort) override;
    std::string summary() const override;

  private:
    /// Where the thread that has asked a rank waits, so that no answer wakes the others.
    struct Desk {
        std::optional<std::string> answer;
        std::condition_variable_any has_come;
    };

    int take_idle_rank();
    /// What the rank has to say of the run; none where a stop was requested first.
    std::optional<std::string> ask(int rank, const std::string& place,
                                   const std::stop_token& abort);
    /// Posts what there is to post, and hands out what has come, until it is asked to stop.
    void be_postman(const std::stop_token& done);
    void post();
    void hand_out(Letter letter);

    Mail& mail_;
    const LauncherProcess& own_;
    std::mutex mutex_;  ///< of all that follows
    std::vector<int> idle_;
    std::deque<std::pair<int, std::string>> to_post_;  ///< rank and place
    std::vector<Desk> desks_;                          ///< by rank
    std::size_t runs_ = 0;
    std::jthread postman_;
};

/// What the launcher process of a rank serves: the first block is the plan, and the others ask for
/// runs of it.
void serve_told_plan(int socket);

/// For the other ranks: does what rank 0 asks for until that says that the program ends.
void be_in_the_crew(Mail& mail, const LauncherProcess& launcher);

}  // namespace asv::tools
