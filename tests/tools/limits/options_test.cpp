#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "io/text/atomic_file.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/files/run_program.hpp"
#include "tests/kit/files/temporary_folder.hpp"

/// Numbers in options: decimal, never wrapped or clamped, their range told where they are refused.

namespace asv::test {
namespace {

using Words = std::vector<std::string>;

Words call(const std::string& program, const TemporaryFolder& folder) {
    const std::string problem = testcase_file("3ASV.txt");
    if (program == "asv-solve") return {problem, folder / "s", "--optimize", "0"};
    if (program == "asv-view") return {problem, "-o", folder / "s.svg"};
    return {problem};
}

struct Refused {
    std::string program, option, value, range;
};

TEST(NumbersInOptions, OutOfRangeIsWrongUsageThatTellsTheRange) {
    const std::string most = "18446744073709551615";
    const std::vector<Refused> all{{"asv-solve", "--seed", "-1", "0 to " + most},
                                   {"asv-solve", "--seed", "18446744073709551616", "0 to " + most},
                                   {"asv-solve", "--seed", "0x10", "0 to " + most},
                                   {"asv-solve", "--seed", "1.5", "0 to " + most},
                                   {"asv-solve", "--seed", "", "0 to " + most},
                                   {"asv-solve", "--threads", "0", "1 to 1024"},
                                   {"asv-solve", "--threads", "1025", "1 to 1024"},
                                   {"asv-solve", "--threads", "-1", "1 to 1024"},
                                   {"asv-solve", "--threads", "18446744073709551617", "1 to 1024"},
                                   {"asv-solve", "--time-limit", "-1", "at least 0"},
                                   {"asv-solve", "--time-limit", "nan", "at least 0"},
                                   {"asv-solve", "--time-limit", "1e400", "at least 0"},
                                   {"asv-solve", "--optimize", "0x1p3", "at least 0"},
                                   {"asv-validate", "--tolerance", "inf", "at least 0"},
                                   {"asv-view", "--bound", "-0.5", "at least 0"},
                                   {"asv-bench", "--seeds", "0", "1 to 1000000"},
                                   {"asv-bench", "--first-seed", "-1", "0 to "},
                                   {"asv-bench", "--jobs", "4294967297", "1 to 1024"},
                                   {"asv-bench", "--threads", "1e3", "1 to 1024"}};
    for (const Refused& refused : all) {
        SCOPED_TRACE(refused.program + " " + refused.option + " " + refused.value);
        const TemporaryFolder folder;
        Words arguments = call(refused.program, folder);
        arguments.insert(arguments.end(), {refused.option, refused.value});
        const Outcome outcome = run_program(refused.program, arguments);
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_NE(outcome.err.find(refused.option), std::string::npos) << outcome.err;
        EXPECT_NE(outcome.err.find(refused.range), std::string::npos) << outcome.err;
        EXPECT_EQ(folder.entries(), 0);
    }
}

TEST(NumbersInOptions, ALeadingZeroIsNoOctalNumber) {
    const TemporaryFolder folder;
    const auto bytes = [&](const std::string& seed, const std::string& name) {
        const std::string file = folder / name;
        const Outcome outcome =
            run_program("asv-solve", {testcase_file("7ASV.txt"), file, "--optimize", "0", "--seed",
                                      seed, "--threads", "01"});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return io::read_file(file);
    };
    const std::string ten = bytes("10", "a");
    EXPECT_EQ(bytes("010", "b"), ten);
    EXPECT_NE(bytes("8", "c"), ten);
    EXPECT_EQ(bytes("08", "d"), bytes("8", "e"));
    EXPECT_NE(bytes("18446744073709551615", "f"), ten);
}

TEST(NumbersInOptions, HelpTellsTheRanges) {
    for (const auto& [program, range] :
         std::vector<std::pair<std::string, std::string>>{{"asv-solve", "1 to 1024"},
                                                          {"asv-bench", "1 to 1000000"},
                                                          {"asv-generate", "1 to 200"},
                                                          {"asv-validate", ">=0"}})
        EXPECT_NE(run_program(program, {"--help"}).out.find(range), std::string::npos) << program;
}

}  // namespace
}  // namespace asv::test
