#include "tools/common/command_line.hpp"

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <new>
#include <stdexcept>
#include <string_view>

#include "geometry/simd/instruction_set.hpp"
#include "io/text/parse_error.hpp"
#include "tools/common/interrupt.hpp"
#include "tools/manual/manual.hpp"

namespace asv::tools {

namespace {

/// What manual pages say of the exit codes.
const std::array<manual::Entry, 8>& exit_codes() {
    static const std::array<manual::Entry, 8> codes{{
        {"0", "Done: solved; valid"},
        {"1", "The answer is no: not solved in the time given; not valid"},
        {"2", "Wrong usage"},
        {"3", "An input cannot be read or understood, or its start or goal is not valid"},
        {"4", "Proven to have no solution"},
        {"5", "An output cannot be written"},
        {"70", "Internal error, or no memory"},
        {"130", "Interrupted by the user, with nothing to write"},
    }};
    return codes;
}

/// What cannot be caught, since it is thrown before main() begins: the library for options makes
/// objects then that need memory.
[[noreturn]] void end_without_abort() {
    const char* message = "internal error\n";
    try {
        if (std::current_exception()) throw;
    } catch (const std::bad_alloc&) {
        message = "out of memory\n";
    } catch (...) {
    }
    std::fputs(message, stderr);
    std::_Exit(static_cast<int>(ExitCode::internal));
}

void obey_environment() {
    try {
        geometry::simd::use_instruction_set_of_environment();
    } catch (const std::invalid_argument& error) {
        throw UsageError(error.what());
    }
}

/// Comes before all other objects of the program.
[[gnu::init_priority(101)]] const struct LastResort {
    LastResort() { std::set_terminate(end_without_abort); }
} last_resort;

}  // namespace

CommandLine::CommandLine(const std::string& program, const std::string& description,
                         const std::string& example)
    : options_(description, program) {
    options_.set_version_flag("--version", program + " " ASV_VERSION);
    options_.add_flag("--quiet", quiet_, "No warnings and no progress on standard error");
    options_.footer("Example:\n  " + example);
}

ExitCode CommandLine::failed(ExitCode code, const std::string& message) const {
    std::cout.flush();
    std::cerr << options_.get_name() << ": " << message << '\n';
    return code;
}

bool CommandLine::write_manual(int argc, const char* const* argv) const {
    if (argc != 3 || std::string_view(argv[1]) != "--manual") return false;
    manual::write(std::cout, argv[2], options_, ASV_VERSION, exit_codes());
    return true;
}

ExitCode CommandLine::parse_and_act(int argc, const char* const* argv,
                                    const std::function<ExitCode()>& action) {
    ExitCode code = ExitCode::done;
    try {
        if (!write_manual(argc, argv)) {
            options_.parse(argc, argv);
            obey_environment();
            code = action();
        }
    } catch (const CLI::ParseError& error) {
        // Asking for help or the version ends here as well.
        if (error.get_exit_code() != 0) {
            return failed(ExitCode::usage,
                          std::string(error.what()) + "\nRun with --help for help.");
        }
        options_.exit(error, std::cout, std::cerr);
    }
    if (!std::cout.flush()) {
        return failed(ExitCode::bad_output, "standard output cannot be written");
    }
    return code;
}

int CommandLine::run(int argc, const char* const* argv,
                     const std::function<ExitCode()>& action) noexcept {
    try {
        return static_cast<int>(outcome(argc, argv, action));
    } catch (...) {
        return report_failed_start(options_.get_name().c_str());
    }
}

ExitCode CommandLine::outcome(int argc, const char* const* argv,
                              const std::function<ExitCode()>& action) {
    ExitCode code = ExitCode::internal;
    end_on_interrupt();
    // A file that may not grow further is then a failed write, not the end of the process.
    std::signal(SIGXFSZ, SIG_IGN);
    try {
        code = parse_and_act(argc, argv, action);
    } catch (const UsageError& error) {
        code = failed(ExitCode::usage, error.what());
    } catch (const io::ParseError& error) {
        // Without the program's name in front, so that editors find the place.
        std::cout.flush();
        std::cerr << error.what() << '\n';
        code = ExitCode::bad_input;
    } catch (const io::ReadError& error) {
        code = failed(ExitCode::bad_input, error.what());
    } catch (const io::WriteError& error) {
        code = failed(ExitCode::bad_output, error.what());
    } catch (const std::bad_alloc&) {
        code = failed(ExitCode::internal, "out of memory");
    } catch (const std::exception& error) {
        code = failed(ExitCode::internal, std::string("internal error: ") + error.what());
    } catch (...) {
        code = failed(ExitCode::internal, "internal error");
    }
    return code;
}

void CommandLine::print(std::span<const io::Warning> warnings) const {
    if (quiet_) return;
    for (const io::Warning& warning : warnings) {
        std::cerr << to_text(warning) << '\n';
    }
}

int report_failed_start(const char* program) noexcept {
    const char* message = "internal error";
    try {
        throw;
    } catch (const std::bad_alloc&) {
        message = "out of memory";
    } catch (...) {
    }
    // Nothing here may need memory.
    std::fprintf(stderr, "%s: %s\n", program, message);
    return static_cast<int>(ExitCode::internal);
}

}  // namespace asv::tools
