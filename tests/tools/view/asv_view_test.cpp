#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/problem/problem_file.hpp"
#include "io/solution/solution_file.hpp"
#include "io/solution/trees_file.hpp"
#include "io/text/atomic_file.hpp"
#include "tests/kit/files/drawing_samples.hpp"
#include "tests/kit/files/run_program.hpp"
#include "tests/kit/files/temporary_folder.hpp"

namespace asv {
namespace {

class ViewProgram : public testing::Test {
  protected:
    void SetUp() override {
        const io::ExhibitInput input =
            test::sample(3, {{0.1, 0.3}, {0.3, 0.3}}, {{{0.5, 0}, {0.6, 0.2}}});
        io::write_problem(path("p.txt"), input.problem);
        io::write_solution(path("s.txt"), *input.solution);
        io::write_trees(path("t.json"),
                        {"auto", 3, {{"start", {{0.1, 0.3}, {0.3, 0.3}}, {-1, 0}}}, {}});
    }

    test::Outcome view(std::vector<std::string> arguments) {
        for (std::string& argument : arguments) {
            if (argument.starts_with("@")) argument = path(argument.substr(1));
        }
        return test::run_program("asv-view", arguments);
    }
    std::string path(const std::string& name) const { return (folder_ / name).string(); }
    std::string text(const std::string& name) const { return io::read_file(folder_ / name); }

    test::TemporaryFolder folder_;
};

TEST_F(ViewProgram, WritesEveryKindAtOnceAndIsSilent) {
    const test::Outcome outcome = view({"@p.txt", "@s.txt", "--trees", "@t.json", "-o", "@a.svg",
                                        "-o", "@a.png", "-o", "@a.pdf", "-o", "@a.html"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out + outcome.err, "");
    EXPECT_TRUE(text("a.svg").starts_with("<?xml"));
    EXPECT_TRUE(text("a.png").starts_with("\x89PNG"));
    EXPECT_TRUE(text("a.pdf").starts_with("%PDF"));
    EXPECT_TRUE(text("a.html").starts_with("<!doctype html>"));
    EXPECT_NE(text("a.svg").find("cost 0.6000 · lower bound 0.5999"), std::string::npos);
}

TEST_F(ViewProgram, ShowsABoundThatIsGivenOrComputed) {
    ASSERT_EQ(view({"@p.txt", "@s.txt", "--bound", "0.5", "-o", "@a.svg"}).exit_code, 0);
    EXPECT_NE(text("a.svg").find("lower bound 0.5000 (ratio 1.200)"), std::string::npos);
    std::ofstream(path("stats.json")) << R"({"planner": "rrt", "cost_lower_bound": 0.4})";
    ASSERT_EQ(view({"@p.txt", "@s.txt", "--stats", "@stats.json", "-o", "@a.svg"}).exit_code, 0);
    EXPECT_NE(text("a.svg").find("lower bound 0.4000 (ratio 1.500)"), std::string::npos);
    EXPECT_NE(text("a.svg").find("· rrt"), std::string::npos);
}

TEST_F(ViewProgram, ThemesDiffer) {
    ASSERT_EQ(view({"@p.txt", "-o", "@light.svg"}).exit_code, 0);
    ASSERT_EQ(view({"@p.txt", "--theme", "dark", "-o", "@dark.svg"}).exit_code, 0);
    EXPECT_NE(text("light.svg"), text("dark.svg"));
    EXPECT_EQ(view({"@p.txt", "--theme", "pink", "-o", "@dark.svg"}).exit_code, 2);
}

TEST_F(ViewProgram, RefusesWrongUsage) {
    const std::vector<std::vector<std::string>> wrong{
        {},
        {"@p.txt"},
        {"@p.txt", "-o", "@a.gif"},
        {"@p.txt", "-o", "@a-%d.png"},
        {"@p.txt", "@s.txt", "-o", "@a.avi"},
        {"@p.txt", "@s.txt", "-o", "@a.svg", "--seconds", "2"},
        {"@p.txt", "@s.txt", "-o", "@a.gif", "--fps", "61"},
        {"@p.txt", "@s.txt", "-o", "@a-%d.png", "-o", "@a-3.png"},
        {"@p.txt", "-o", "@svg"},
        {"@p.txt", "@s.txt", "@s.txt", "-o", "@a.svg"},
        {"@p.txt", "--solutions", "@.", "-o", "@a.svg"},
        {"@p.txt", "--gallery", "@g", "-o", "@a.svg"},
        {"@p.txt", "--gallery", "@g", "--bound", "3"},
        {"@p.txt", "--bound", "-1", "-o", "@a.svg"},
    };
    for (const auto& arguments : wrong) {
        const test::Outcome outcome = view(arguments);
        EXPECT_EQ(outcome.exit_code, 2) << testing::PrintToString(arguments);
        EXPECT_NE(outcome.err, "");
    }
    EXPECT_EQ(folder_.entries(), 3) << "nothing was written";
}

TEST_F(ViewProgram, SaysWhichInputItCannotRead) {
    EXPECT_EQ(view({"@missing.txt", "-o", "@a.svg"}).exit_code, 3);
    EXPECT_EQ(view({"@p.txt", "@missing.txt", "-o", "@a.svg"}).exit_code, 3);
    const test::Outcome solution = view({"@p.txt", "@p.txt", "-o", "@a.svg"});
    EXPECT_EQ(solution.exit_code, 3);
    EXPECT_NE(solution.err.find("p.txt:1:"), std::string::npos) << solution.err;
    const test::Outcome trees = view({"@p.txt", "--trees", "@s.txt", "-o", "@a.svg"});
    EXPECT_EQ(trees.exit_code, 3);
    EXPECT_NE(trees.err.find("s.txt:1:"), std::string::npos) << trees.err;
    EXPECT_EQ(folder_.entries(), 3);
}

TEST_F(ViewProgram, AnOutputThatCannotBeWrittenIsFive) {
    EXPECT_EQ(view({"@p.txt", "-o", "@no/such/folder/a.svg"}).exit_code, 5);
    EXPECT_EQ(view({"@p.txt", "--gallery", "@p.txt/g"}).exit_code, 5);
}

TEST_F(ViewProgram, GalleryShowsAllAndEndsWithThreeWhenACaseIsBroken) {
    std::filesystem::create_directory(path("solutions"));
    std::filesystem::rename(path("s.txt"), path("solutions/p.solution.txt"));
    const test::Outcome good = view({"--gallery", "@g", "--solutions", "@solutions", "@p.txt"});
    EXPECT_EQ(good.exit_code, 0) << good.err;
    EXPECT_NE(text("g/index.html").find("cost 0.6000"), std::string::npos);
    std::ofstream(path("broken.txt")) << "x";
    const test::Outcome bad = view({"--gallery", "@g", "@p.txt", "@broken.txt"});
    EXPECT_EQ(bad.exit_code, 3);
    EXPECT_NE(bad.err.find("broken.txt:1:1"), std::string::npos) << bad.err;
    EXPECT_NE(text("g/index.html").find("p.html"), std::string::npos);
}

TEST_F(ViewProgram, MakesNumberedPicturesOfAWay) {
    const test::Outcome outcome = view({"@p.txt", "@s.txt", "-o", "@a-%03d.png", "-o", "@b-%d.png",
                                        "--seconds", "0.5", "--fps", "8"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const char* name : {"a-000.png", "a-003.png", "b-0.png", "b-3.png"})
        EXPECT_TRUE(text(name).starts_with("\x89PNG")) << name;
    EXPECT_EQ(text("a-002.png"), text("b-2.png"));
    EXPECT_NE(text("a-000.png"), text("a-003.png"));
    EXPECT_EQ(folder_.entries(), 3 + 2 * 4);
}

TEST_F(ViewProgram, MakesFilms) {
    if (!std::filesystem::exists("/usr/bin/ffmpeg"))
        GTEST_SKIP() << "ffmpeg is not installed (Debian package ffmpeg)";
    const test::Outcome outcome = view({"@p.txt", "@s.txt", "-o", "@a.gif", "-o", "@a.mp4", "-o",
                                        "@a.webm", "--seconds", "0.5", "--fps", "8"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out + outcome.err, "");
    EXPECT_TRUE(text("a.gif").starts_with("GIF89a"));
    EXPECT_EQ(text("a.mp4").substr(4, 4), "ftyp");
    EXPECT_TRUE(text("a.webm").starts_with("\x1A\x45\xDF\xA3"));
    EXPECT_EQ(folder_.entries(), 6);
}

TEST_F(ViewProgram, SaysWhatAFilmNeeds) {
    test::Surroundings without;
    without.environment = {"PATH=/nowhere"};
    const test::Outcome outcome =
        test::run_program("asv-view", {path("p.txt"), path("s.txt"), "-o", path("a.gif")}, without);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find("needs the program ffmpeg"), std::string::npos) << outcome.err;
    EXPECT_EQ(folder_.entries(), 3);
}

TEST_F(ViewProgram, HelpHasAnExample) {
    const test::Outcome help = view({"--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_NE(help.out.find("Example:"), std::string::npos);
    EXPECT_EQ(view({"--version"}).exit_code, 0);
}

}  // namespace
}  // namespace asv
