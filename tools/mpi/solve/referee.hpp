#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/solve/solve.hpp"
#include "tools/mpi/mail.hpp"
#include "tools/mpi/solve/race_end.hpp"
#include "tools/mpi/solve/racer.hpp"

namespace asv::tools {

/// Rank 0 of one race: it runs itself, listens to the others, and says when it is over.
class Referee {
  public:
    /// Begins; the other ranks have their orders. Precondition: mail and problem outlive this.
    Referee(Mail& mail, const core::Problem& problem, core::SolveOptions options);

    /// Until the race is over; the result of the best rank.
    core::SolveResult run();

    /// The rank whose path that is; none where there is no path.
    std::optional<int> winner() const { return winner_; }

    /// Seconds of the time limit that the ranks have: the end takes time as well.
    static double limit_of_ranks(double time_limit);

  private:
    /// What a rank that has none yet does about a path.
    struct Runner {
        bool found = false;     ///< has one of its own
        bool provided = false;  ///< was given one, or told to end
    };

    double elapsed() const;
    bool time_is_up() const;
    void listen();
    void take(const Letter& letter);
    void look_at_own();
    void note_path(int rank);
    bool waits(int rank) const;
    void provide_those_without_a_path();
    /// Tells each of them; own is for rank 0.
    template <class Own>
    void tell_those_who_wait(Tag tag, const std::string& bytes, Own own);
    void hand_out(const std::string& path);
    void stop();
    bool is_over() const;
    core::SolveResult collect();
    bool fetch(int rank, core::SolveResult& result);

    Mail& mail_;
    const core::Problem& problem_;
    core::SolveOptions options_;
    core::Clock::time_point begun_ = core::Clock::now();
    std::vector<Runner> runners_;  ///< by rank
    Finishes finishes_;            ///< likewise
    std::optional<int> first_finder_;
    double found_at_ = 0;  ///< seconds
    bool provided_ = false;
    double best_cost_ = std::numeric_limits<double>::infinity();
    std::optional<double> end_by_;  ///< seconds, once all were told to stop
    std::optional<core::Path> solution_;
    std::optional<int> winner_;
    Racer own_;
};

}  // namespace asv::tools
