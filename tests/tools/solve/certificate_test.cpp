#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/text/atomic_file.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/files/run_program.hpp"
#include "tests/kit/files/temporary_folder.hpp"
#include "tests/kit/files/text.hpp"

/// asv-solve --certificate and asv-validate --certificate, as their users see them.

namespace asv::test {
namespace {

using Words = std::vector<std::string>;

class CertificatePrograms : public testing::Test {
  protected:
    std::string in(const std::string& name) const { return (folder_ / name).string(); }

    Outcome prove(const std::string& problem, const std::string& certificate) const {
        return run_program("asv-solve", {problem, in("s"), "--certificate", certificate,
                                         "--optimize", "0", "--time-limit", "30"});
    }

    Outcome check(const std::string& problem, const Words& more = {}) const {
        Words words = {problem, "--certificate", in("c")};
        words.insert(words.end(), more.begin(), more.end());
        return run_program("asv-validate", words);
    }

    TemporaryFolder folder_;
};

const Words infeasible = {"enclosed-goal", "enclosed-start", "opposite-orientation", "two-asvs",
                          "wall-across"};

TEST_F(CertificatePrograms, ProveAndAcceptEveryProblemWithoutAPath) {
    for (const std::string& name : infeasible) {
        const std::string problem = testcase_file("infeasible/" + name + ".txt");
        EXPECT_EQ(prove(problem, in("c")).exit_code, 4) << name;
        const Outcome outcome = check(problem);
        EXPECT_EQ(outcome.exit_code, 0) << name << outcome.out;
        EXPECT_EQ(lines_of(outcome.out).back(),
                  "accepted: no path exists that the validator accepts");
        EXPECT_FALSE(std::filesystem::exists(in("s")));
    }
}

TEST_F(CertificatePrograms, ProveGeneratedProblems) {
    const std::vector<Words> families = {{"corridor", "-n", "7", "--height-factor", "0.95"},
                                         {"corridor", "-n", "3", "--height-factor", "0.9"},
                                         {"rooms", "-n", "5", "--infeasible", "fenced"},
                                         {"maze", "-n", "4", "--infeasible", "turned"}};
    for (Words words : families) {
        words.insert(words.end(), {"--seed", "3", "--quiet", "-o", in("p")});
        ASSERT_EQ(run_program("asv-generate", words).exit_code, 0) << words[0];
        EXPECT_EQ(prove(in("p"), in("c")).exit_code, 4) << words[0];
        const Outcome outcome = check(in("p"));
        EXPECT_EQ(outcome.exit_code, 0) << words[0] << outcome.out;
    }
}

TEST_F(CertificatePrograms, RefuseThatOfAnotherProblem) {
    prove(testcase_file("infeasible/wall-across.txt"), in("c"));
    const Outcome outcome = check(testcase_file("3ASV.txt"), {"--json", in("v")});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.out.find("digest                    FAILED  it is that of another problem"),
              std::string::npos)
        << outcome.out;
    EXPECT_EQ(lines_of(outcome.out).back(), "refused");
    const auto verdict = nlohmann::json::parse(io::read_file(in("v")));
    EXPECT_EQ(verdict["accepted"], false);
    EXPECT_EQ(verdict["claims"].size(), lines_of(outcome.out).size() - 1);
}

TEST_F(CertificatePrograms, WriteNoneForAProblemThatIsSolved) {
    const Outcome outcome = prove(testcase_file("3ASV.txt"), in("c"));
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_NE(
        outcome.err.find("--certificate " + in("c") + " is not written: the problem is solved"),
        std::string::npos)
        << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(in("c")));
}

TEST_F(CertificatePrograms, WriteToStandardOutputAndReadStandardInput) {
    const std::string problem = testcase_file("infeasible/two-asvs.txt");
    const Outcome written = prove(problem, "-");
    EXPECT_EQ(written.exit_code, 4);
    io::write_file(in("c"), written.out);
    Surroundings surroundings;
    surroundings.standard_input = in("c");
    const Outcome read =
        run_program("asv-validate", {problem, "--certificate", "-", "--json", "-"}, surroundings);
    EXPECT_EQ(read.exit_code, 0) << read.err;
    EXPECT_EQ(nlohmann::json::parse(read.out)["certificate"], "-");
}

TEST_F(CertificatePrograms, RefuseFilesThatAreTheSameOrNotUnderstood) {
    const std::string problem = testcase_file("infeasible/two-asvs.txt");
    io::write_file(in("p"), io::read_file(problem));
    EXPECT_EQ(prove(in("p"), in("p")).exit_code, 2);
    EXPECT_EQ(prove(in("p"), in("s")).exit_code, 2);
    EXPECT_EQ(prove(in("p"), in("no/c")).exit_code, 5);
    prove(in("p"), in("c"));
    EXPECT_EQ(check(in("p"), {"--json", in("c")}).exit_code, 2);
    EXPECT_EQ(check(in("p"), {"--tolerance", "1e-4"}).exit_code, 2);
    io::write_file(in("s"), "0 0\n");
    EXPECT_EQ(run_program("asv-validate", {in("p"), in("s"), "--certificate", in("c")}).exit_code,
              2);
    io::write_file(in("c"), "{\"version\": 1}");
    const Outcome outcome = check(in("p"));
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_NE(outcome.err.find("c:1:1: expected a member at problem, found nothing"),
              std::string::npos)
        << outcome.err;
}

}  // namespace
}  // namespace asv::test
