#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/model/problem.hpp"
#include "io/problem/generation_file.hpp"
#include "tools/families/family_commands.hpp"

namespace asv::tools {

/// A problem of a family and how it came about.
struct GeneratedProblem {
    core::Problem problem;
    /// But for the name of the file, and without a verdict where none was asked for.
    io::Generation generation;
};

/// All that asv-generate is asked, but for where the problem goes.
class Generator {
  public:
    /// Adds the options of all families, and a subcommand for each.
    explicit Generator(CLI::App& app);
    Generator(const Generator&) = delete;
    Generator& operator=(const Generator&) = delete;

    /// Throws UsageError, in the words of asv-generate, unless a family was named and all that was
    /// given is understood. Precondition: the app has parsed; so for the others.
    void require_understood() const;

    bool wants_verdict() const { return solvable_; }

    /// Draws the problem. Throws UsageError where the options do not go together or leave no room.
    GeneratedProblem draw() const;

    /// Likewise where a start is given and a goal is asked for: no family may be named, and no
    /// option that the start decides.
    void require_understood_with_start() const;
    /// Draws the goal; see core::draw_goal(), whose precondition it has, for what it keeps.
    GeneratedProblem draw_goal(const core::Problem& problem) const;

  private:
    const Family* named_family() const;
    /// The name stands for the family, whose command there may be.
    GeneratedProblem drawn(const std::string& name, const CLI::App* command,
                           const std::function<core::Problem(core::Rng&)>& draw) const;

    CLI::App& app_;
    core::ChainOptions chain_;
    std::uint64_t seed_ = 1;
    bool solvable_ = false;
    std::size_t attempts_ = 1;
    std::vector<Family> families_;
};

/// What asv-generate writes for these words ("corridor", "-n", "7"): the same numbers. Throws
/// UsageError in its words; -o and what else is about files is unknown here.
GeneratedProblem generated(const std::vector<std::string>& words);

}  // namespace asv::tools
