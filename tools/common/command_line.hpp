#pragma once

#include <functional>
#include <span>
#include <stdexcept>
#include <string>

#include <CLI/CLI.hpp>

#include "io/problem/problem_file.hpp"

namespace asv::tools {

/// What every program tells its caller.
enum class ExitCode : int {
    done = 0,           ///< solved; valid
    no = 1,             ///< not solved in the time given; not valid
    usage = 2,          ///< wrong arguments
    bad_input = 3,      ///< an input cannot be read or understood, or its start or goal is invalid
    infeasible = 4,     ///< proven to have no solution
    bad_output = 5,     ///< an output cannot be written
    internal = 70,      ///< a bug
    interrupted = 130,  ///< by the user, with nothing to show
};

/// A combination of arguments that makes no sense: exit code 2.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// The arguments of one program, with --help, --version and --quiet, and the one place where
/// everything that may go wrong becomes a message on standard error and an exit code.
class CommandLine {
  public:
    /// example: a call of the program that --help shows.
    CommandLine(const std::string& program, const std::string& description,
                const std::string& example);

    /// Add the program's own options here.
    CLI::App& options() { return options_; }
    bool quiet() const { return quiet_; }

    /// Parses the arguments, calls the action and returns the exit code of the process. A wrong
    /// argument gives 2, io::ParseError and io::ReadError 3, io::WriteError and a standard output
    /// that cannot be written 5, anything else that is thrown 70.
    int run(int argc, const char* const* argv, const std::function<ExitCode()>& action) noexcept;

    /// "FILE:LINE:COLUMN: warning: MESSAGE" on standard error, one line each; nothing with --quiet.
    void print(std::span<const io::Warning> warnings) const;

  private:
    ExitCode parse_and_act(int argc, const char* const* argv,
                           const std::function<ExitCode()>& action);
    ExitCode failed(ExitCode code, const std::string& message) const;

    CLI::App options_;
    bool quiet_ = false;
};

/// Accepts finite numbers of at least 0; what the library offers lets NaN pass.
CLI::Validator finite_and_not_negative();

}  // namespace asv::tools
