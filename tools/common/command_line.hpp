#pragma once

#include <functional>
#include <span>
#include <stdexcept>
#include <string>

#include <CLI/CLI.hpp>

#include "io/problem/problem_file.hpp"
#include "tools/common/exit_code.hpp"

namespace asv::tools {

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

    /// Parses the arguments, obeys ASV_SIMD (docs/programs.md), calls the action and returns the
    /// exit code of the process. A wrong argument gives 2, io::ParseError and io::ReadError 3,
    /// io::WriteError and a standard output that cannot be written 5, anything else that is
    /// thrown 70.
    /// `--manual man|bash|zsh|fish` alone prints the manual page or a completion; the build calls
    /// it.
    int run(int argc, const char* const* argv, const std::function<ExitCode()>& action) noexcept;

    /// "FILE:LINE:COLUMN: warning: MESSAGE" on standard error, one line each; nothing with --quiet.
    void print(std::span<const io::Warning> warnings) const;

  private:
    bool write_manual(int argc, const char* const* argv) const;
    /// run() as far as messages can be made.
    ExitCode outcome(int argc, const char* const* argv, const std::function<ExitCode()>& action);
    ExitCode parse_and_act(int argc, const char* const* argv,
                           const std::function<ExitCode()>& action);
    ExitCode failed(ExitCode code, const std::string& message) const;

    CLI::App options_;
    bool quiet_ = false;
};

/// The type name of options that take problem files; tools/manual/command.hpp tells of type names.
inline constexpr const char* problem_file = "FILE.txt|.json";

/// For a program that fails before its command line is there, or has no memory even for a message:
/// prints one line and returns exit code 70. Precondition: called where an exception is caught.
int report_failed_start(const char* program) noexcept;

}  // namespace asv::tools
