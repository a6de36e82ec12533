#pragma once

#include <string>

#include "core/solve/solve.hpp"
#include "tools/mpi/mail.hpp"
#include "tools/solve/arguments.hpp"

namespace asv::tools {

/// OR-parallel solving: all ranks of MPI race on one problem, each with racers of its own
/// (SolveOptions::first_racer), and the best path of all is the result.
///
/// Each rank finds a path and improves it, as one process does. Those that have none yet soon after
/// the first rank has one give up their search and improve that one, or with nothing to improve
/// (--optimize 0) end. All end when one of them proves that its path cannot be improved, or that
/// there is none; when the best cost of all meets a lower bound; or when the time is up.
class RankRace {
  public:
    /// For rank 0. Precondition: mail outlives this.
    explicit RankRace(Mail& mail) : mail_(mail) {}

    /// As core::solve(). The validator has passed the path on this rank. Throws UsageError where
    /// trees are asked for, which one rank would have of a search that another one has won.
    core::SolveResult solve(const SolveArguments& arguments, const core::Problem& problem,
                            const core::SolveOptions& options);

    /// Whose path it is, and what was sent.
    std::string summary() const;

  private:
    Mail& mail_;
    std::string winner_ = "no path";
};

/// For the other ranks: races where rank 0 asks for it, until that says that the program ends.
void help_in_the_race(Mail& mail);

}  // namespace asv::tools
