#include "tests/kit/files/malformed_files.hpp"

#include <filesystem>
#include <ostream>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/text/atomic_file.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/files/run_program.hpp"
#include "tests/kit/files/temporary_folder.hpp"

/// Every program that reads problems, on files that cannot be read, understood or written.

namespace asv::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// How a program is called to read a problem and to write a file.
struct Program {
    std::string name;
    Words before_output;  ///< what stands between problem and output
    Words options;
    int invalid_state;  ///< exit code when start or goal violate a requirement

    Words arguments(const fs::path& problem, const fs::path& output) const {
        Words words = {problem.string()};
        words.insert(words.end(), before_output.begin(), before_output.end());
        words.push_back(output.string());
        words.insert(words.end(), options.begin(), options.end());
        return words;
    }
};

void PrintTo(const Program& program, std::ostream* stream) {
    *stream << program.name;
}

const std::vector<Program> programs = {
    {"asv-validate", {"--json"}, {}, 1},
    {"asv-solve", {}, {"--quiet", "--threads", "1", "--time-limit", "20", "--optimize", "0"}, 3},
};

constexpr std::size_t little_memory = std::size_t{512} << 20U;

class EveryProgram : public testing::TestWithParam<Program> {
  protected:
    Outcome run(const fs::path& problem, const fs::path& output,
                const Surroundings& surroundings = {}) const {
        return run_program(GetParam().name, GetParam().arguments(problem, output), surroundings);
    }

    fs::path write(const std::string& name, const std::string& content) const {
        io::write_file(folder_ / name, content);
        return folder_ / name;
    }

    /// Exit code 5, a message that names the output and the reason, and nothing left behind.
    void expect_unwritable(const fs::path& output, const std::string& reason,
                           const Surroundings& surroundings = {}) const {
        SCOPED_TRACE(output);
        const Outcome outcome = run(problem_, output, surroundings);
        EXPECT_EQ(outcome.exit_code, 5) << outcome.err;
        EXPECT_NE(outcome.err.find(output.string() + ": " + reason), std::string::npos)
            << outcome.err;
    }

    TemporaryFolder folder_;
    fs::path problem_ = write("good.txt", joined(good_problem()));
};

std::string label(const testing::TestParamInfo<Program>& program) {
    return program.param.name.substr(program.param.name.find('-') + 1);
}

INSTANTIATE_TEST_SUITE_P(Tools, EveryProgram, testing::ValuesIn(programs), label);

TEST(Corpus, HasSixtyMalformedFilesAndMore) {
    std::set<std::string> names;
    std::set<std::string> contents;
    for (const Malformed& malformed : malformed_problems()) {
        EXPECT_TRUE(names.insert(malformed.name).second) << malformed.name;
        EXPECT_TRUE(contents.insert(malformed.content).second) << malformed.name;
    }
    EXPECT_GE(names.size(), 60U);
}

TEST_P(EveryProgram, UnderstandsTheFileThatTheOthersAreMadeFrom) {
    const Outcome outcome = run(problem_, folder_ / "out");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    EXPECT_TRUE(fs::exists(folder_ / "out"));
}

TEST_P(EveryProgram, ExplainsWhyAProblemCannotBeUnderstood) {
    for (const Malformed& malformed : malformed_problems()) {
        SCOPED_TRACE(malformed.name);
        const fs::path problem = write("problem.txt", malformed.content);
        const Outcome outcome =
            run(problem, folder_ / "out", {.memory = little_memory, .standard_output = {}});
        EXPECT_EQ(outcome.exit_code, 3);
        EXPECT_EQ(outcome.err.find(problem.string() + ":" + malformed.message), 0U) << outcome.err;
        EXPECT_EQ(outcome.out, "");
        EXPECT_FALSE(fs::exists(folder_ / "out"));
    }
}

TEST_P(EveryProgram, ExplainsWhyAProblemCannotBeRead) {
    const auto expect_unreadable = [&](const fs::path& problem, const std::string& reason) {
        const Outcome outcome = run(problem, folder_ / "out");
        EXPECT_EQ(outcome.exit_code, 3) << problem;
        EXPECT_EQ(outcome.err, GetParam().name + ": " + problem.string() + ": " + reason + "\n");
        EXPECT_FALSE(fs::exists(folder_ / "out"));
    };
    expect_unreadable(folder_ / "missing", "No such file or directory");
    expect_unreadable(folder_.path(), "Is a directory");
    expect_unreadable(problem_ / "file", "Not a directory");
    expect_unreadable(folder_ / std::string(300, 'n'), "File name too long");
}

// Root may read everything, so the program is run as nobody where that is possible.
TEST_P(EveryProgram, ExplainsThatAProblemIsProtected) {
    fs::permissions(folder_.path(), fs::perms{0777});
    fs::permissions(problem_, fs::perms{0000});
    const Surroundings nobody{.user = ::geteuid() == 0 ? 65534U : 0U, .standard_output = {}};
    const Outcome outcome = run(problem_, folder_ / "out", nobody);
    if (outcome.exit_code == cannot_start) GTEST_SKIP() << "nobody cannot start the program";
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_NE(outcome.err.find(problem_.string() + ": Permission denied"), std::string::npos);
}

TEST_P(EveryProgram, RefusesEveryFileOfTheInvalidTestCases) {
    int files = 0;
    for (const auto& entry : fs::directory_iterator(testcase_file("invalid"))) {
        SCOPED_TRACE(entry.path());
        const Outcome outcome = run(entry.path(), folder_ / "out");
        const bool understood = outcome.err.find("expected") == std::string::npos;
        EXPECT_EQ(outcome.exit_code, understood ? GetParam().invalid_state : 3) << outcome.err;
        ++files;
    }
    EXPECT_GT(files, 0);
}

TEST_P(EveryProgram, ExplainsWhyTheOutputCannotBeWritten) {
    expect_unwritable(folder_ / "no" / "out", "No such file or directory");
    expect_unwritable(folder_.path(), "Is a directory");
    expect_unwritable(problem_ / "out", "Not a directory");
    EXPECT_EQ(folder_.entries(), 1);
}

TEST_P(EveryProgram, ExplainsThatTheOutputIsProtected) {
    const fs::path locked = folder_ / "locked";
    fs::create_directory(locked);
    fs::permissions(locked, fs::perms{0555});
    fs::permissions(folder_.path(), fs::perms{0755});
    const Surroundings nobody{.user = ::geteuid() == 0 ? 65534U : 0U, .standard_output = {}};
    if (run(problem_, "/dev/null", nobody).exit_code == cannot_start) {
        GTEST_SKIP() << "nobody cannot start the program";
    }
    expect_unwritable(locked / "out", "Permission denied", nobody);
}

TEST_P(EveryProgram, ExplainsThatADeviceIsFull) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
    expect_unwritable("/dev/full", "No space left on device");
}

TEST_P(EveryProgram, LeavesNothingBehindWhenAFileMayNotGrow) {
    const fs::path output = write("out", "what was there before");
    expect_unwritable(output, "File too large", {.largest_file = 64, .standard_output = {}});
    EXPECT_EQ(io::read_file(output), "what was there before");
    EXPECT_EQ(folder_.entries(), 2);
}

TEST_P(EveryProgram, LeavesNothingBehindOnAFullDisk) {
    const fs::path disk = folder_ / "disk";
    fs::create_directory(disk);
    if (::mount("none", disk.c_str(), "tmpfs", 0, "size=4k") != 0) {
        GTEST_SKIP() << "a small file system cannot be mounted";
    }
    io::write_file(disk / "filler", std::string(4096, 'x'));
    expect_unwritable(disk / "out", "No space left on device");
    const auto left = std::distance(fs::directory_iterator(disk), fs::directory_iterator());
    EXPECT_EQ(::umount(disk.c_str()), 0);
    EXPECT_EQ(left, 1);
}

TEST(Validate, ExplainsWhyASolutionCannotBeUnderstood) {
    const TemporaryFolder folder;
    io::write_file(folder / "p", joined(good_problem()));
    for (const Malformed& malformed : malformed_solutions()) {
        SCOPED_TRACE(malformed.name);
        io::write_file(folder / "s", malformed.content);
        const Outcome outcome =
            run_program("asv-validate", {(folder / "p").string(), (folder / "s").string()},
                        {.memory = little_memory, .standard_output = {}});
        EXPECT_EQ(outcome.exit_code, 3);
        EXPECT_EQ(outcome.err.find((folder / "s").string() + ":" + malformed.message), 0U)
            << outcome.err;
        EXPECT_EQ(outcome.out, "");
    }
}

TEST(Validate, ExplainsWhyASolutionCannotBeRead) {
    const TemporaryFolder folder;
    io::write_file(folder / "p", joined(good_problem()));
    for (const fs::path& solution : {folder / "missing", folder.path()}) {
        const Outcome outcome =
            run_program("asv-validate", {(folder / "p").string(), solution.string()});
        EXPECT_EQ(outcome.exit_code, 3);
        EXPECT_NE(outcome.err.find(solution.string() + ": "), std::string::npos);
    }
}

}  // namespace
}  // namespace asv::test
