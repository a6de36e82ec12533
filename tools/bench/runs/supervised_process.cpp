#include "tools/bench/runs/supervised_process.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tools/bench/runs/process_end.hpp"
#include "tools/common/descriptor.hpp"

namespace asv::tools {

namespace {

using Clock = std::chrono::steady_clock;

/// More than this of what a program says last is not kept.
constexpr std::size_t longest_last_words = 200;

double seconds_since(Clock::time_point begun) {
    return std::chrono::duration<double>(Clock::now() - begun).count();
}

sigset_t signals_of_supervision() {
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGCHLD);
    sigaddset(&set, SIGTERM);
    return set;
}

/// The program begins as a shell would start it, but in a process group of its own.
[[noreturn]] void become(const std::vector<std::string>& words, pid_t supervisor, int errors,
                         std::size_t megabytes) {
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != supervisor) ::_exit(1);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXFSZ})
        std::signal(signal, SIG_DFL);
    sigset_t none;
    sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    const int nothing = ::open("/dev/null", O_RDWR);
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(nothing, STDOUT_FILENO);
    ::dup2(errors, STDERR_FILENO);
    ::close_range(STDERR_FILENO + 1, ~0U, 0);
    limit_memory(megabytes);
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    ::execvp(arguments[0], arguments.data());
    ::dprintf(STDERR_FILENO, "%s: %s\n", arguments[0], std::strerror(errno));
    constexpr int not_started = 127;  // as shells have it
    ::_exit(not_started);
}

/// Keeps what was written last.
class Tail {
  public:
    /// Reads what there is; false at the end.
    bool read_from(int in) {
        std::array<char, 4096> block;
        const ssize_t got = ::read(in, block.data(), block.size());
        if (got < 0) return errno == EAGAIN || errno == EINTR;
        text_.append(block.data(), static_cast<std::size_t>(got));
        if (text_.size() > block.size()) text_.erase(0, text_.size() - block.size());
        return got > 0;
    }

    std::string last_line() const {
        const std::size_t last = text_.find_last_not_of(" \t\r\n");
        if (last == std::string::npos) return {};
        const std::size_t before = text_.find_last_of("\r\n", last);
        const std::size_t begin = before == std::string::npos ? 0 : before + 1;
        return text_.substr(begin, std::min(last + 1 - begin, longest_last_words));
    }

  private:
    std::string text_;
};

bool has_ended(pid_t process) {
    siginfo_t info{};
    // Left as it is, so that its number, which is its group's too, stays taken.
    return ::waitid(P_PID, static_cast<id_t>(process), &info, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           info.si_pid == process;
}

/// Was SIGTERM among the signals that have come?
bool called_off(int signals) {
    signalfd_siginfo info{};
    bool off = false;
    while (::read(signals, &info, sizeof info) == sizeof info)
        off = off || info.ssi_signo == SIGTERM;
    return off;
}

/// Waits until the process has ended or is not to go on, and listens to it.
void watch(pid_t process, int signals, int errors, double most_seconds, Clock::time_point begun,
           Tail& tail, SupervisedEnd& end) {
    constexpr double longest_wait = 1000;
    std::array<pollfd, 2> events{{{signals, POLLIN, 0}, {errors, POLLIN, 0}}};
    while (!has_ended(process)) {
        const double left = most_seconds - seconds_since(begun);
        end.timed_out = left <= 0;
        if (end.timed_out) return;
        const int milliseconds = static_cast<int>(1000 * std::min(left, longest_wait)) + 1;
        if (::poll(events.data(), events.size(), milliseconds) <= 0) continue;
        end.called_off = events[0].revents != 0 && called_off(signals);
        if (end.called_off) return;
        // A descriptor below 0 is left out.
        if (events[1].revents != 0 && !tail.read_from(errors)) events[1].fd = -1;
    }
}

}  // namespace

void hold_signals_of_supervision() {
    std::signal(SIGTERM, SIG_DFL);
    const sigset_t set = signals_of_supervision();
    ::sigprocmask(SIG_BLOCK, &set, nullptr);
}

SupervisedEnd run_supervised(const std::vector<std::string>& words, double most_seconds,
                             std::size_t megabytes) {
    const sigset_t set = signals_of_supervision();
    const Descriptor signals(::signalfd(-1, &set, SFD_CLOEXEC | SFD_NONBLOCK));
    if (signals.number() < 0) throw_errno("signalfd");
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0) throw_errno("pipe");
    const Descriptor errors(ends[0]);
    Descriptor other_end(ends[1]);
    const pid_t supervisor = ::getpid();
    const auto begun = Clock::now();
    const pid_t process = ::fork();
    if (process < 0) throw_errno("fork");
    if (process == 0) become(words, supervisor, ends[1], megabytes);
    ::setpgid(process, process);
    other_end.close();
    SupervisedEnd end;
    Tail tail;
    watch(process, signals.number(), errors.number(), most_seconds, begun, tail, end);
    end.seconds = seconds_since(begun);
    ::kill(-process, SIGKILL);
    rusage used{};
    while (::wait4(process, &end.status, 0, &used) < 0 && errno == EINTR) {
    }
    end.peak_memory = peak_memory(used);
    pollfd more{errors.number(), POLLIN, 0};
    while (::poll(&more, 1, 0) > 0 && tail.read_from(errors.number())) {
    }
    end.last_words = tail.last_line();
    return end;
}

bool is_program(const std::string& name) {
    const auto runs = [](const std::filesystem::path& file) {
        std::error_code error;
        return std::filesystem::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0;
    };
    if (name.find('/') != std::string::npos) return runs(name);
    const char* path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "/usr/bin:/bin" : path);
    for (std::string folder; std::getline(folders, folder, ':');)
        if (runs(std::filesystem::path(folder.empty() ? "." : folder) / name)) return true;
    return false;
}

}  // namespace asv::tools
