#include "tools/bench/runs/run_launcher.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include "io/text/write_all.hpp"
#include "tools/bench/runs/external_run.hpp"
#include "tools/bench/runs/machine.hpp"
#include "tools/bench/runs/process_end.hpp"
#include "tools/bench/runs/run_bytes.hpp"
#include "tools/bench/runs/supervised_process.hpp"

namespace asv::tools {

namespace {

using core::BenchmarkRun;

/// What comes before the bytes of a run: how its process ended, and how many bytes there are.
struct Ending {
    int status = 0;
    double seconds = 0;           ///< that the process lived
    std::size_t peak_memory = 0;  ///< bytes, resident
    std::size_t size = 0;
};

/// Up to size bytes; fewer when the other end is closed.
std::string read_up_to(int in, std::size_t size) {
    std::string bytes;
    std::array<char, 65536> block;
    while (bytes.size() < size) {
        const ssize_t got = ::read(in, block.data(), std::min(block.size(), size - bytes.size()));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) break;
        bytes.append(block.data(), static_cast<std::size_t>(got));
    }
    return bytes;
}

template <class Value>
bool read_value(int in, Value& value) {
    const std::string bytes = read_up_to(in, sizeof value);
    if (bytes.size() < sizeof value) return false;
    std::memcpy(&value, bytes.data(), sizeof value);
    return true;
}

/// false, and no signal, when the other end is closed. A value fits the buffer of a socket.
template <class Value>
bool send_value(int socket, const Value& value) {
    return ::send(socket, &value, sizeof value, MSG_NOSIGNAL) == sizeof value;
}

int wait_for(pid_t child, rusage& used) {
    int status = 0;
    while (::wait4(child, &status, 0, &used) < 0 && errno == EINTR) {
    }
    return status;
}

[[noreturn]] void fail(const char* what) {
    throw std::system_error(errno, std::generic_category(), what);
}

/// The process gets this signal when its parent ends.
void follow(pid_t parent, int signal) {
    ::prctl(PR_SET_PDEATHSIG, signal);
    if (::getppid() != parent) ::_exit(1);
}

[[noreturn]] void be_run(const core::BenchmarkPlan& plan, const core::RunPlace& place, int out) {
    const bool external = plan.planners[place.planner].external();
    if (!external) limit_memory(plan.memory_limit);
    BenchmarkRun run;
    try {
        run = external ? run_external(plan, place) : core::run_once(plan, place);
    } catch (const std::bad_alloc&) {
        run.fault = "out of memory";
    } catch (const std::exception& error) {
        run.fault = error.what();
    }
    // That of another program has been measured from outside.
    if (!external) run.peak_memory_bytes = peak_memory();
    Packer packer;
    exchange(packer, run);
    // Nothing of the launcher's is to be flushed or undone a second time.
    ::_exit(io::write_all(out, packer.bytes()) ? 0 : 1);
}

/// One run in a process of its own; tells how that ended, then what it sent. False when nobody
/// listens any more.
bool run_and_tell(const core::BenchmarkPlan& plan, const core::RunPlace& place, int socket) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) fail("pipe");
    const pid_t launcher = ::getpid();
    const auto begun = core::Clock::now();
    const pid_t child = ::fork();
    if (child < 0) fail("fork");
    if (child == 0) {
        // Who watches over another program has to end it first.
        const bool external = plan.planners[place.planner].external();
        if (external) hold_signals_of_supervision();
        follow(launcher, external ? SIGTERM : SIGKILL);
        be_run(plan, place, ends[1]);
    }
    ::close(ends[1]);
    const std::string bytes = read_up_to(ends[0], std::string::npos);
    ::close(ends[0]);
    rusage used{};
    Ending ending;
    ending.status = wait_for(child, used);
    ending.seconds = std::chrono::duration<double>(core::Clock::now() - begun).count();
    ending.peak_memory = peak_memory(used);
    ending.size = bytes.size();
    return send_value(socket, ending) && io::write_all(socket, bytes);
}

/// Ctrl-C reaches every process of a terminal; what it means is the program's to say.
void leave_interrupts_to_the_program() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
}

[[noreturn]] void be_launcher(const core::BenchmarkPlan& plan, int socket) {
    leave_interrupts_to_the_program();
    // The sockets of the other launchers: each has to end with the program alone.
    ::close_range(STDERR_FILENO + 1, static_cast<unsigned>(socket) - 1, 0);
    ::close_range(static_cast<unsigned>(socket) + 1, ~0U, 0);
    try {
        core::RunPlace place;
        while (read_value(socket, place) && run_and_tell(plan, place, socket)) {
        }
        ::_exit(0);
    } catch (const std::exception&) {
        ::_exit(1);
    }
}

/// Milliseconds until somebody who has asked for a stop is heard.
constexpr int between_looks = 10;

/// Waits until the launcher answers; false when a stop is requested first.
bool wait_for_answer(int socket, const std::stop_token& abort) {
    while (!abort.stop_requested()) {
        pollfd wait{socket, POLLIN, 0};
        if (::poll(&wait, 1, between_looks) > 0) return true;
    }
    return false;
}

/// A run whose process has ended without a word.
BenchmarkRun lost_run(const Ending& ending, std::size_t memory_limit) {
    BenchmarkRun run;
    if (ran_out_of_memory(ending.status, ending.peak_memory, memory_limit)) {
        run.status = core::RunStatus::memory_limit;
        run.reason = memory_reason(memory_limit);
        run.spent.time_total = ending.seconds;
        run.peak_memory_bytes = ending.peak_memory;
    } else {
        run.fault.append("the run ").append(how_it_ended(ending.status));
    }
    return run;
}

BenchmarkRun read_run(int socket, std::size_t memory_limit) {
    BenchmarkRun run;
    Ending ending;
    if (!read_value(socket, ending)) {
        run.fault = "the process that starts the runs has ended";
        return run;
    }
    const std::string bytes = read_up_to(socket, ending.size);
    if (!WIFEXITED(ending.status) || WEXITSTATUS(ending.status) != 0)
        return lost_run(ending, memory_limit);
    Unpacker unpacker(bytes);
    exchange(unpacker, run);
    return run;
}

}  // namespace

RunLauncher::RunLauncher(const core::BenchmarkPlan& plan) : plan_(plan) {
    idle_.push_back(start());
    try {
        while (idle_.size() < plan.jobs) idle_.push_back(start());
    } catch (const std::system_error&) {
        // The system grants no more processes: those that there are have to do.
    }
}

RunLauncher::~RunLauncher() {
    for (const Process& process : idle_) {
        ::close(process.socket);
        rusage used{};
        wait_for(process.id, used);
    }
}

RunLauncher::Process RunLauncher::start() const {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) fail("socketpair");
    const pid_t program = ::getpid();
    const pid_t launcher = ::fork();
    if (launcher < 0) fail("fork");
    if (launcher == 0) {
        follow(program, SIGKILL);
        be_launcher(plan_, ends[1]);
    }
    ::close(ends[1]);
    return {launcher, ends[0]};
}

RunLauncher::Process RunLauncher::take() {
    const std::lock_guard lock(mutex_);
    const Process process = idle_.back();
    idle_.pop_back();
    return process;
}

void RunLauncher::give_back(Process process) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(process);
}

core::BenchmarkRun RunLauncher::run(const core::RunPlace& place, const std::stop_token& abort) {
    const Process process = take();
    BenchmarkRun run;
    if (!send_value(process.socket, place))
        run.fault = "the process that starts the runs has ended";
    else if (wait_for_answer(process.socket, abort))
        run = read_run(process.socket, plan_.memory_limit);
    else
        ::kill(process.id, SIGKILL);
    give_back(process);
    run.place = place;
    return run;
}

}  // namespace asv::tools
