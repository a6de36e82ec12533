#include "tools/bench/run_in_child.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "io/text/write_all.hpp"
#include "tools/bench/machine.hpp"

namespace asv::tools {

namespace {

using core::BenchmarkRun;
using History = std::vector<std::pair<double, double>>;

/// Bytes of values one after the other: both ends are one program.
class Packer {
  public:
    template <class Value>
    requires std::is_trivially_copyable_v<Value>
    void operator()(const Value& value) {
        bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    }
    void operator()(const std::string& text) {
        (*this)(text.size());
        bytes_ += text;
    }
    void operator()(const History& history) {
        (*this)(history.size());
        for (const auto& [time, cost] : history) {
            (*this)(time);
            (*this)(cost);
        }
    }
    const std::string& bytes() const { return bytes_; }

  private:
    std::string bytes_;
};

class Unpacker {
  public:
    explicit Unpacker(std::string_view bytes) : bytes_(bytes) {}

    template <class Value>
    requires std::is_trivially_copyable_v<Value>
    void operator()(Value& value) { std::memcpy(&value, take(sizeof value).data(), sizeof value); }
    void operator()(std::string& text) { text = take(size()); }
    void operator()(History& history) {
        history.resize(size());
        for (auto& [time, cost] : history) {
            (*this)(time);
            (*this)(cost);
        }
    }

  private:
    std::size_t size() {
        std::size_t count = 0;
        (*this)(count);
        return count;
    }
    std::string_view take(std::size_t count) {
        const std::string_view taken = bytes_.substr(0, count);
        bytes_.remove_prefix(count);
        return taken;
    }

    std::string_view bytes_;
};

/// Everything of a run but its place, which both ends know.
template <class Archive, class Run>
void exchange(Archive& archive, Run& run) {
    archive(run.status);
    archive(run.reason);
    archive(run.fault);
    archive(run.primitive_steps);
    archive(run.peak_memory_bytes);
    auto& spent = run.spent;
    for (auto* number : {&spent.time_to_first, &spent.time_total, &spent.cost_first, &spent.cost,
                         &spent.cost_of_search, &spent.cost_lower_bound})
        archive(*number);
    for (auto* count :
         {&spent.steps_lower_bound, &spent.tree_nodes[0], &spent.tree_nodes[1], &spent.iterations})
        archive(*count);
    archive(spent.state_checks);
    archive(spent.edge_checks);
    archive(spent.cost_history);
}

[[noreturn]] void be_child(const core::BenchmarkPlan& plan, const core::RunPlace& place, int out) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    // The pipes of other jobs: each has to end with its own child.
    ::close_range(STDERR_FILENO + 1, static_cast<unsigned>(out) - 1, 0);
    ::close_range(static_cast<unsigned>(out) + 1, ~0U, 0);
    BenchmarkRun run;
    try {
        run = core::run_once(plan, place);
    } catch (const std::exception& error) {
        run.fault = error.what();
    }
    run.peak_memory_bytes = peak_memory();
    Packer packer;
    exchange(packer, run);
    // Nothing of the parent's is to be flushed or undone a second time.
    ::_exit(io::write_all(out, packer.bytes()) ? 0 : 1);
}

/// What the child sends until it ends; it is killed when a stop is requested.
std::string receive(pid_t child, int in, const std::stop_token& abort) {
    std::string bytes;
    std::array<char, 65536> block;
    while (true) {
        pollfd wait{in, POLLIN, 0};
        if (::poll(&wait, 1, 50) == 0) {
            if (abort.stop_requested()) ::kill(child, SIGKILL);
            continue;
        }
        const ssize_t got = ::read(in, block.data(), block.size());
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return bytes;
        bytes.append(block.data(), static_cast<std::size_t>(got));
    }
}

std::string how_it_ended(int status) {
    if (WIFSIGNALED(status))
        return "the run was ended by signal " + std::to_string(WTERMSIG(status)) + " (" +
               ::strsignal(WTERMSIG(status)) + ")";
    return "the run ended with exit code " + std::to_string(WEXITSTATUS(status));
}

[[noreturn]] void fail(const char* what) {
    throw std::system_error(errno, std::generic_category(), what);
}

}  // namespace

BenchmarkRun run_in_child(const core::BenchmarkPlan& plan, const core::RunPlace& place,
                          const std::stop_token& abort) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) fail("pipe");
    const pid_t child = ::fork();
    if (child < 0) fail("fork");
    if (child == 0) be_child(plan, place, ends[1]);
    ::close(ends[1]);
    const std::string bytes = receive(child, ends[0], abort);
    ::close(ends[0]);
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    BenchmarkRun run;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
        Unpacker unpacker(bytes);
        exchange(unpacker, run);
    } else if (!abort.stop_requested()) {
        run.fault = how_it_ended(status);
    }
    run.place = place;
    return run;
}

}  // namespace asv::tools
