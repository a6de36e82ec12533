#include "tests/kit/files/run_program.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "io/text/atomic_file.hpp"
#include "tests/kit/files/temporary_folder.hpp"
#include "tests/kit/sanitizers.hpp"

namespace asv::test {
namespace {

void limit(__rlimit_resource_t resource, std::size_t value) {
    const rlimit limits{value, value};
    if (value != 0 && ::setrlimit(resource, &limits) != 0) ::_exit(cannot_start);
}

void redirect(const std::filesystem::path& file, int flags, int descriptor) {
    const int opened = ::open(file.c_str(), flags, 0600);
    if (opened < 0 || ::dup2(opened, descriptor) < 0) ::_exit(cannot_start);
}

[[noreturn]] void become(std::vector<char*> words, const Surroundings& surroundings,
                         const std::filesystem::path& out, const std::filesystem::path& err) {
    const auto& input = surroundings.standard_input;
    redirect(input.empty() ? "/dev/null" : input, O_RDONLY, STDIN_FILENO);
    redirect(out, O_WRONLY | O_CREAT, STDOUT_FILENO);
    redirect(err, O_WRONLY | O_CREAT, STDERR_FILENO);
    const std::string found = "exitcode=" + std::to_string(sanitizer_exit_code);
    ::setenv("ASAN_OPTIONS", found.c_str(), 1);
    ::setenv("UBSAN_OPTIONS", found.c_str(), 1);
    // As a shell has it: the signal of a write beyond the limit would end the process.
    std::signal(SIGXFSZ, SIG_DFL);
    limit(RLIMIT_FSIZE, surroundings.largest_file);
    if (!sanitized) limit(RLIMIT_AS, surroundings.memory);
    limit(RLIMIT_NPROC, surroundings.most_processes);
    for (const std::string& entry : surroundings.environment)
        ::putenv(const_cast<char*>(entry.c_str()));
    if (surroundings.user != 0 && ::setuid(surroundings.user) != 0) ::_exit(cannot_start);
    ::alarm(60);
    ::execv(words[0], words.data());
    ::_exit(cannot_start);
}

/// It stays there to be asked how it ended.
bool has_ended(pid_t child) {
    siginfo_t state{};
    return ::waitid(P_PID, static_cast<id_t>(child), &state, WEXITED | WNOHANG | WNOWAIT) != 0 ||
           state.si_pid == child;
}

void send_signals(pid_t child, const Surroundings& surroundings) {
    constexpr std::chrono::milliseconds between_looks{10};
    if (surroundings.first_signal_when)
        while (!surroundings.first_signal_when() && !has_ended(child))
            std::this_thread::sleep_for(between_looks);
    for (const int signal : surroundings.signals) {
        std::this_thread::sleep_for(std::chrono::milliseconds(surroundings.before_each_signal));
        ::kill(child, signal);
    }
}

}  // namespace

Outcome run_program(const std::string& name, const std::vector<std::string>& arguments,
                    const Surroundings& surroundings) {
    const TemporaryFolder folder;
    std::string program = (std::filesystem::path(ASV_PROGRAM_DIR) / name).string();
    std::vector<std::string> copies = arguments;
    std::vector<char*> words = {program.data()};
    for (std::string& word : copies) words.push_back(word.data());
    words.push_back(nullptr);
    const bool own_output = surroundings.standard_output.empty();
    const auto out = own_output ? folder / "out" : surroundings.standard_output;
    // They are there also when the program is killed before it has begun.
    if (own_output) std::ofstream{out};
    std::ofstream{folder / "err"};
    const pid_t child = ::fork();
    if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
    if (child == 0) become(words, surroundings, out, folder / "err");
    send_signals(child, surroundings);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    Outcome outcome;
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    if (own_output) outcome.out = io::read_file(out);
    outcome.err = io::read_file(folder / "err");
    return outcome;
}

}  // namespace asv::test
