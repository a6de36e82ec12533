#include "tools/common/command_line.hpp"

#include <cmath>
#include <csignal>
#include <exception>
#include <iostream>
#include <new>

#include "io/text/parse_error.hpp"

namespace asv::tools {

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

ExitCode CommandLine::parse_and_act(int argc, const char* const* argv,
                                    const std::function<ExitCode()>& action) {
    ExitCode code = ExitCode::done;
    try {
        options_.parse(argc, argv);
        code = action();
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
    ExitCode code = ExitCode::internal;
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
    return static_cast<int>(code);
}

void CommandLine::print(std::span<const io::Warning> warnings) const {
    if (quiet_) return;
    for (const io::Warning& warning : warnings) {
        std::cerr << to_text(warning) << '\n';
    }
}

CLI::Validator finite_and_not_negative() {
    const auto check = [](const std::string& text) -> std::string {
        double value = 0;
        if (CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value >= 0) return {};
        return "'" + text + "' is not a finite number of at least 0";
    };
    return {check, ">=0"};
}

}  // namespace asv::tools
