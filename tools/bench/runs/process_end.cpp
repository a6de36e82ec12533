#include "tools/bench/runs/process_end.hpp"

#include <cstring>
#include <new>

#include <sys/wait.h>
#include <unistd.h>

namespace asv::tools {

namespace {

constexpr std::size_t megabyte = std::size_t{1} << 20U;

/// None of those that programs use.
constexpr int memory_exit_code = 71;

/// Memory is asked for in pieces, and the first one that is too large is not resident.
constexpr double near_the_limit = 0.75;

}  // namespace

void limit_memory(std::size_t megabytes) {
    if (megabytes == 0) return;
    const rlimit limit{megabytes * megabyte, megabytes * megabyte};
    ::setrlimit(RLIMIT_DATA, &limit);
    // At once, since what is half done cannot be told from what is done.
    std::set_new_handler([] { ::_exit(memory_exit_code); });
}

bool ran_out_of_memory(int status, std::size_t peak_memory, std::size_t megabytes) {
    if (megabytes == 0) return false;
    if (WIFEXITED(status) && WEXITSTATUS(status) == memory_exit_code) return true;
    const bool failed = !WIFEXITED(status) || WEXITSTATUS(status) != 0;
    const auto limit = static_cast<double>(megabytes * megabyte);
    return failed && static_cast<double>(peak_memory) >= near_the_limit * limit;
}

std::string memory_reason(std::size_t megabytes) {
    return "it wanted more than " + std::to_string(megabytes) + " MB of memory";
}

std::string how_it_ended(int status) {
    if (WIFSIGNALED(status))
        return "was ended by signal " + std::to_string(WTERMSIG(status)) + " (" +
               ::strsignal(WTERMSIG(status)) + ")";
    return "ended with exit code " + std::to_string(WEXITSTATUS(status));
}

std::size_t peak_memory(const rusage& used) {
    constexpr std::size_t kibibyte = 1024;
    return kibibyte * static_cast<std::size_t>(used.ru_maxrss);
}

}  // namespace asv::tools
