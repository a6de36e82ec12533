#include <chrono>
#include <csignal>
#include <filesystem>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "io/text/atomic_file.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/files/run_program.hpp"
#include "tests/kit/files/temporary_folder.hpp"
#include "tests/kit/random.hpp"
#include "tests/kit/sanitizers.hpp"
#include "tests/kit/scaled.hpp"

/// Whatever fails while a program has files at work, or whoever kills it: its output is what it was
/// or whole, nothing else is left behind, and it says what went wrong.

namespace asv::test {
namespace {

using Words = std::vector<std::string>;
namespace fs = std::filesystem;

constexpr const char* old_content = "what was there before\n";

/// A program that writes one file, whose content is always the same.
struct Job {
    std::string program;
    Words before_output, after_output;
};

Words arguments(const Job& job, const std::string& output) {
    Words words = job.before_output;
    words.push_back(output);
    words.insert(words.end(), job.after_output.begin(), job.after_output.end());
    return words;
}

Job job_of(const std::string& program) {
    const std::string problem = testcase_file("3ASV.txt");
    if (program == "asv-solve") return {program, {problem}, {"--optimize", "0", "--threads", "1"}};
    if (program == "asv-view") return {program, {problem, "-o"}, {}};
    return {program, {"corridor", "-n", "5", "-o"}, {}};
}

class OneFileWritten : public testing::TestWithParam<std::string> {
  protected:
    OneFileWritten() : job_(job_of(GetParam())), output_(folder_ / "output.html") {
        EXPECT_EQ(run_program(job_.program, arguments(job_, output_)).exit_code, 0);
        new_content_ = io::read_file(output_);
    }

    Outcome run(const Surroundings& surroundings) {
        io::write_file(output_, old_content);
        return run_program(job_.program, arguments(job_, output_), surroundings);
    }

    bool is_old() const { return io::read_file(output_) == old_content; }
    bool is_new() const { return io::read_file(output_) == new_content_; }

    void expect_nothing_else() const {
        for (const auto& entry : fs::directory_iterator(fs::path(output_).parent_path()))
            EXPECT_EQ(entry.path().string(), output_);
    }

    /// What a killed program began goes on for a moment in its child (io/text/temporary_file.cpp).
    void wait_for_the_last_rename() const {
        const auto files = [&] {
            return std::distance(fs::directory_iterator(fs::path(output_).parent_path()), {});
        };
        for (int i = 0; i < 1000 && files() > 1; ++i)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }

    const TemporaryFolder folder_;
    const Job job_;
    const std::string output_;
    std::string new_content_;
};

/// Each call fails in turn, and with it those that follow or not: a lone failure may be made good
/// by another way to write the file.
TEST_P(OneFileWritten, IsWholeOrOldWhicheverCallFails) {
    if (sanitized) GTEST_SKIP() << "a sanitizer lets nothing be loaded before itself";
    for (const bool alone : {true, false}) {
        int failed = 0, untouched = 0;
        for (int call = 1; untouched < 4; ++call) {
            SCOPED_TRACE("call " + std::to_string(call) + (alone ? "" : " and all later ones"));
            Surroundings surroundings;
            surroundings.environment = {"LD_PRELOAD=" ASV_FAILING_FILES,
                                        "ASV_FAILING_FILE_CALL=" + std::to_string(call)};
            if (!alone) surroundings.environment.push_back("ASV_FAILING_FROM_THERE_ON=1");
            const Outcome outcome = run(surroundings);
            expect_nothing_else();
            const bool fine = outcome.exit_code == 0;
            untouched = fine ? untouched + 1 : 0;
            if (!fine) ++failed;
            EXPECT_TRUE(fine || outcome.exit_code == 3 || outcome.exit_code == 5)
                << outcome.exit_code << ": " << outcome.err;
            EXPECT_TRUE(is_new() || (!fine && is_old()));
            EXPECT_TRUE(fine || !outcome.err.empty());
        }
        EXPECT_TRUE(alone || failed > 2);
    }
}

TEST_P(OneFileWritten, TakesWritesThatAreShort) {
    if (sanitized) GTEST_SKIP() << "a sanitizer lets nothing be loaded before itself";
    Surroundings surroundings;
    surroundings.environment = {"LD_PRELOAD=" ASV_FAILING_FILES, "ASV_SHORT_WRITES=1"};
    EXPECT_EQ(run(surroundings).exit_code, 0);
    EXPECT_TRUE(is_new());
}

TEST_P(OneFileWritten, IsWholeOrOldWheneverItIsKilled) {
    Random random(1);
    int killed = 0;
    for (std::size_t i = 0; i < scaled(40); ++i) {
        Surroundings surroundings;
        surroundings.signals = {SIGKILL};
        surroundings.before_each_signal = static_cast<unsigned>(3 + random.below(20));
        const Outcome outcome = run(surroundings);
        SCOPED_TRACE(std::to_string(surroundings.before_each_signal) + " ms");
        if (outcome.exit_code == -SIGKILL) ++killed;
        wait_for_the_last_rename();
        EXPECT_TRUE(is_new() || (outcome.exit_code != 0 && is_old()));
        expect_nothing_else();
    }
    EXPECT_GE(killed, 1);
}

INSTANTIATE_TEST_SUITE_P(Of, OneFileWritten,
                         testing::Values("asv-solve", "asv-view", "asv-generate"),
                         [](const auto& tested) { return tested.param.substr(4); });

}  // namespace
}  // namespace asv::test
