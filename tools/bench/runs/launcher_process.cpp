#include "tools/bench/runs/launcher_process.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <new>
#include <system_error>

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
#include "tools/common/descriptor.hpp"
#include "tools/common/end_at_once.hpp"

namespace asv::tools {

namespace {

using core::BenchmarkRun;

/// How the process of a run ended.
struct Ending {
    int status = 0;
    double seconds = 0;           ///< that the process lived
    std::size_t peak_memory = 0;  ///< bytes, resident
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

/// false, and no signal, when the other end is closed.
bool send_all(int socket, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) continue;
        if (sent < 0) return false;
        bytes.remove_prefix(static_cast<std::size_t>(sent));
    }
    return true;
}

/// Its size, then its bytes.
bool send_block(int socket, std::string_view block) {
    Packer size;
    size(block.size());
    return send_all(socket, size.bytes()) && send_all(socket, block);
}

int wait_for(pid_t child, rusage& used) {
    int status = 0;
    while (::wait4(child, &status, 0, &used) < 0 && errno == EINTR) {
    }
    return status;
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
    // Nothing of the launcher's is to be flushed or undone a second time.
    end_at_once(io::write_all(out, run_bytes(run)) ? 0 : 1);
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

/// One run in a process of its own: what that has to tell, or what is to be told of its end.
std::string bytes_of_run(const core::BenchmarkPlan& plan, const core::RunPlace& place) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) throw_errno("pipe");
    const pid_t launcher = ::getpid();
    const auto begun = core::Clock::now();
    const pid_t child = ::fork();
    if (child < 0) throw_errno("fork");
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
    if (WIFEXITED(ending.status) && WEXITSTATUS(ending.status) == 0) return bytes;
    return run_bytes(lost_run(ending, plan.memory_limit));
}

/// Ctrl-C reaches every process of a terminal; what it means is the program's to say.
void leave_interrupts_to_the_program() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_IGN);
}

[[noreturn]] void be_launcher(const std::function<void(int)>& serve, int socket) {
    leave_interrupts_to_the_program();
    // The sockets of the other launchers: each has to end with the program alone.
    ::close_range(STDERR_FILENO + 1, static_cast<unsigned>(socket) - 1, 0);
    ::close_range(static_cast<unsigned>(socket) + 1, ~0U, 0);
    try {
        serve(socket);
        end_at_once(0);
    } catch (const std::exception&) {
        end_at_once(1);
    }
}

/// Milliseconds until somebody who has asked for a stop is heard.
constexpr int between_looks = 10;

/// Waits until the other end answers; false when the answer is not wanted any more.
bool wait_for_answer(int socket, const std::function<bool()>& abandoned) {
    while (!abandoned()) {
        pollfd wait{socket, POLLIN, 0};
        if (::poll(&wait, 1, between_looks) > 0) return true;
    }
    return false;
}

}  // namespace

std::optional<std::string> read_block(int socket) {
    std::size_t size = 0;
    const std::string head = read_up_to(socket, sizeof size);
    if (head.size() < sizeof size) return std::nullopt;
    Unpacker{head}(size);
    std::string block = read_up_to(socket, size);
    if (block.size() < size) return std::nullopt;
    return block;
}

void serve_runs(const core::BenchmarkPlan& plan, int socket) {
    while (const std::optional<std::string> question = read_block(socket)) {
        core::RunPlace place;
        Unpacker{*question}(place);
        if (!send_block(socket, bytes_of_run(plan, place))) return;
    }
}

BenchmarkRun answered_run(const std::optional<std::string>& answer, const core::RunPlace& place) {
    BenchmarkRun run;
    if (answer) {
        Unpacker unpacker(*answer);
        exchange(unpacker, run);
    } else {
        run.fault = "the process that starts the runs has ended";
    }
    run.place = place;
    return run;
}

LauncherProcess::LauncherProcess(const std::function<void(int)>& serve) {
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
        throw_errno("socketpair");
    const pid_t program = ::getpid();
    id_ = ::fork();
    if (id_ < 0) throw_errno("fork");
    if (id_ == 0) {
        follow(program, SIGKILL);
        be_launcher(serve, ends[1]);
    }
    ::close(ends[1]);
    socket_ = ends[0];
}

LauncherProcess::~LauncherProcess() {
    ::close(socket_);
    rusage used{};
    wait_for(id_, used);
}

bool LauncherProcess::tell(std::string_view block) const {
    return send_block(socket_, block);
}

std::optional<std::string> LauncherProcess::ask(std::string_view block,
                                                const std::function<bool()>& abandoned) const {
    if (!send_block(socket_, block)) return std::nullopt;
    if (wait_for_answer(socket_, abandoned)) return read_block(socket_);
    ::kill(id_, SIGKILL);
    return std::nullopt;
}

}  // namespace asv::tools
