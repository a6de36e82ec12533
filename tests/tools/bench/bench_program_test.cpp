#include "tools/bench/bench_program.hpp"

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/kit/chains/problems.hpp"
#include "tests/kit/files/temporary_folder.hpp"
#include "tests/kit/files/text.hpp"

/// The program with a crew that only says what it has been told to say.

namespace asv::tools {
namespace {

using test::contains;

/// Each run ends with the fault, where there is one.
struct Crew {
    std::string fault, summary;
};

class FakeCrew : public RunCrew {
  public:
    explicit FakeCrew(Crew crew) : crew_(std::move(crew)) {}
    std::size_t size() const override { return 1; }
    core::BenchmarkRun run(const core::RunPlace& place, const std::stop_token&) override {
        core::BenchmarkRun run;
        run.place = place;
        run.reason = "nobody looked for a path";
        run.fault = crew_.fault;
        return run;
    }
    std::string summary() const override { return crew_.summary; }

  private:
    Crew crew_;
};

struct Ended {
    int exit_code = 0;
    std::string out, err;
};

Ended bench_with(const Crew& crew, std::size_t jobs, const std::vector<std::string>& options) {
    std::vector<std::string> words{"asv-bench", test::testcase_file("3ASV.txt")};
    words.insert(words.end(), options.begin(), options.end());
    std::vector<const char*> arguments;
    for (const std::string& word : words) arguments.push_back(word.c_str());
    const auto hire = [&](const core::BenchmarkPlan&) { return std::make_unique<FakeCrew>(crew); };
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    Ended ended;
    ended.exit_code =
        run_bench_program(static_cast<int>(arguments.size()), arguments.data(), {hire, jobs});
    ended.out = testing::internal::GetCapturedStdout();
    ended.err = testing::internal::GetCapturedStderr();
    return ended;
}

TEST(BenchWithACrew, AFaultIsABugThatCanBeRepeated) {
    const test::TemporaryFolder folder;
    const std::string csv = (folder / "runs.csv").string();
    const Ended ended = bench_with({"it broke", ""}, 0, {"--first-seed", "7", "--csv", csv});
    EXPECT_EQ(ended.exit_code, 70);
    EXPECT_EQ(ended.err,
              "asv-bench: a bug, nothing was written: it broke\nIt comes again with\n  "
              "asv-solve " +
                  test::testcase_file("3ASV.txt") +
                  " solution.txt --planner auto --seed 7 --time-limit 10 --optimize 0 "
                  "--threads 1\n");
    EXPECT_EQ(folder.entries(), 0);
}

TEST(BenchWithACrew, ItsSummaryIsToldUnlessQuietIsAskedFor) {
    EXPECT_TRUE(contains(bench_with({"", "4 ranks"}, 0, {}).err, "asv-bench: 4 ranks\n"));
    EXPECT_EQ(bench_with({"", "4 ranks"}, 0, {"--quiet"}).err, "");
}

TEST(BenchWithACrew, ASiteThatDecidesOnItsJobsTakesNone) {
    EXPECT_EQ(bench_with({"", ""}, 3, {"--quiet"}).exit_code, 0);
    const Ended ended = bench_with({"", ""}, 3, {"--jobs", "2"});
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_EQ(ended.err, "asv-bench: --jobs: under MPI every rank makes one run at a time\n");
}

}  // namespace
}  // namespace asv::tools
