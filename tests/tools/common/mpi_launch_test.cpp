#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "tests/kit/chains/problems.hpp"
#include "tests/kit/files/run_program.hpp"
#include "tests/kit/files/temporary_folder.hpp"
#include "tests/kit/files/text.hpp"

/// Programs that a launcher of MPI has started without their siblings that know MPI.

namespace asv::test {
namespace {

/// A copy that has nothing beside it.
std::filesystem::path copy_of(const std::string& program, const TemporaryFolder& folder) {
    const auto copy = folder / program;
    std::filesystem::copy_file(std::filesystem::path(ASV_PROGRAM_DIR) / program, copy);
    return copy;
}

Surroundings launched(const std::string& processes, const std::string& rank) {
    Surroundings surroundings;
    surroundings.environment = {"OMPI_COMM_WORLD_SIZE=" + processes,
                                "OMPI_COMM_WORLD_RANK=" + rank};
    return surroundings;
}

TEST(MpiLaunch, WithoutMpiTheFirstProcessSaysSoForAll) {
    const TemporaryFolder folder;
    for (const std::string program : {"asv-bench", "asv-solve"}) {
        const std::string copy = copy_of(program, folder).string();
        const std::vector<std::string> arguments{testcase_file("3ASV.txt"),
                                                 (folder / "out.txt").string()};
        const Outcome first = run_program(copy, arguments, launched("2", "0"));
        EXPECT_EQ(first.exit_code, 2);
        EXPECT_TRUE(contains(first.err, "built without MPI")) << first.err;
        const Outcome second = run_program(copy, arguments, launched("2", "1"));
        EXPECT_EQ(second.err, "");
        EXPECT_EQ(second.out, "");
        EXPECT_FALSE(std::filesystem::exists(folder / "out.txt"));
    }
}

TEST(MpiLaunch, AloneItIsTheProgramThatItIs) {
    const TemporaryFolder folder;
    const std::string copy = copy_of("asv-solve", folder).string();
    const std::string file = (folder / "out.txt").string();
    const Outcome outcome = run_program(
        copy, {testcase_file("3ASV.txt"), file, "--optimize", "0", "--quiet"}, launched("1", "0"));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_TRUE(std::filesystem::exists(file));
}

}  // namespace
}  // namespace asv::test
