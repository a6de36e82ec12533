#include "tools/bench/runs/process_end.hpp"

#include <csignal>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>

namespace asv::tools {
namespace {

constexpr std::size_t megabyte = std::size_t{1} << 20U;
constexpr int memory_exit_code = 71;

int exited(int code) {
    return W_EXITCODE(code, 0);
}

int ended_by(int signal) {
    return W_EXITCODE(0, signal);
}

TEST(ProcessEnd, IsForLackOfMemoryWhereItSaysSoOrFailsNearItsLimit) {
    struct Case {
        int status;
        std::size_t peak_megabytes;
        std::size_t limit;
        bool expected;
    };
    const std::vector<Case> cases{{exited(memory_exit_code), 1, 100, true},
                                  {exited(memory_exit_code), 1, 0, false},
                                  {exited(1), 80, 100, true},
                                  {exited(1), 70, 100, false},
                                  {exited(0), 100, 100, false},
                                  {ended_by(SIGKILL), 80, 100, true},
                                  {ended_by(SIGKILL), 70, 100, false},
                                  {ended_by(SIGKILL), 80, 0, false}};
    for (const Case& c : cases)
        EXPECT_EQ(ran_out_of_memory(c.status, c.peak_megabytes * megabyte, c.limit), c.expected)
            << c.status << ", " << c.peak_megabytes << " of " << c.limit;
}

TEST(ProcessEnd, IsToldInWords) {
    EXPECT_EQ(how_it_ended(exited(3)), "ended with exit code 3");
    EXPECT_EQ(how_it_ended(ended_by(SIGSEGV)), "was ended by signal 11 (Segmentation fault)");
    EXPECT_EQ(memory_reason(100), "it wanted more than 100 MB of memory");
}

}  // namespace
}  // namespace asv::tools
