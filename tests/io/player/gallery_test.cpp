#include "io/player/gallery.hpp"

#include <array>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/problem/problem_file.hpp"
#include "io/solution/solution_file.hpp"
#include "io/solution/trees_file.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/parse_error.hpp"
#include "tests/kit/files/drawing_samples.hpp"
#include "tests/kit/files/temporary_folder.hpp"

namespace asv::io {
namespace {

using test::sample;

class Gallery : public ::testing::Test {
  protected:
    void SetUp() override {
        std::filesystem::create_directory(folder_ / "cases");
        const ExhibitInput input = sample(3, {{0.1, 0.3}, {0.2, 0.3}}, {{{0.4, 0}, {0.5, 0.2}}});
        write_problem(folder_ / "cases/b.txt", input.problem);
        write_solution(folder_ / "cases/b.solution.txt", *input.solution);
        write_problem(folder_ / "cases/a&a.txt", input.problem);
        std::ofstream(folder_ / "cases/c.txt") << "nonsense\n";
    }
    test::TemporaryFolder folder_;
};

TEST_F(Gallery, FindsProblemsWithTheirSolutions) {
    const std::vector<std::filesystem::path> cases{folder_ / "cases", folder_ / "cases/b.txt"};
    const auto found = find_exhibits(cases, std::nullopt);
    ASSERT_EQ(found.size(), 4U);
    EXPECT_EQ(found[0].problem.filename(), "a&a.txt");
    EXPECT_FALSE(found[0].solution);
    EXPECT_EQ(found[1].solution->filename(), "b.solution.txt");
    const std::vector<std::filesystem::path> missing{folder_ / "missing"};
    EXPECT_THROW(find_exhibits(missing, std::nullopt), ReadError);
}

TEST_F(Gallery, PutsCasesInTheirNaturalOrder) {
    for (const char* name : {"15ASV.txt", "3ASV.txt", "7ASV-x10.txt", "7ASV-x2.txt"})
        std::ofstream(folder_ / "cases" / name) << "nonsense\n";
    const auto found = find_exhibits(std::vector{folder_ / "cases"}, std::nullopt);
    std::vector<std::string> names;
    for (const ExhibitFiles& files : found) names.push_back(files.problem.stem().string());
    EXPECT_EQ(names,
              (std::vector<std::string>{"3ASV", "7ASV-x2", "7ASV-x10", "15ASV", "a&a", "b", "c"}));
}

TEST_F(Gallery, WritesPicturesPlayersAndAnIndexOfAll) {
    const std::vector<std::filesystem::path> cases{folder_ / "cases", folder_ / "cases/b.txt"};
    const GalleryReport report = write_gallery(folder_ / "out", find_exhibits(cases, std::nullopt));
    EXPECT_EQ(report.shown, 3U);
    ASSERT_EQ(report.failures.size(), 1U);
    EXPECT_EQ(report.failures[0].name, "c");
    for (const char* name : {"a&a", "b", "b-2"}) {
        for (const char* ending :
             {".light.svg", ".dark.svg", ".light.small.svg", ".dark.small.svg", ".html"}) {
            EXPECT_TRUE(std::filesystem::exists(folder_ / "out" / (std::string(name) + ending)))
                << name << ending;
        }
    }
    const std::string index = read_file(folder_ / "out/index.html");
    EXPECT_NE(index.find("href=\"a%26a.html\""), std::string::npos);
    EXPECT_NE(index.find(">a&amp;a</a>"), std::string::npos);
    EXPECT_NE(index.find("c.txt:1:1: expected"), std::string::npos);
    EXPECT_NE(index.find("src=\"b.light.small.svg\""), std::string::npos);
    EXPECT_NE(index.find("<a href=\"b.dark.svg\" aria-label=\"Picture of b, dark\">"),
              std::string::npos);
    EXPECT_EQ(index.find(folder_.path().string()), std::string::npos) << "no folder names";
}

/// Writes the gallery of b.txt alone, with these files beside it; what its index says.
std::string index_beside(const std::filesystem::path& folder, const std::string& trees,
                         const std::string& stats) {
    write_file(folder / "cases/b.trees.json", trees);
    write_file(folder / "cases/b.stats.json", stats);
    write_gallery(folder / "out",
                  find_exhibits(std::vector{folder / "cases/b.txt"}, folder / "cases"));
    return read_file(folder / "out/index.html");
}

TEST_F(Gallery, ShowsWhatTheSolverHasWrittenBesideAProblem) {
    const std::string trees = format_trees({"rrt", 3, {{"start", {{0.1, 0.3}}, {-1}}}, {}});
    const std::string index = index_beside(
        folder_.path(), trees, R"({"planner": "rrt & more", "cost_lower_bound": 0.0625})");
    EXPECT_NE(index.find("<p>1 problem. "), std::string::npos) << index;
    EXPECT_NE(index.find("lower bound 0.0625"), std::string::npos) << index;
    EXPECT_NE(index.find("rrt &amp; more</p>"), std::string::npos) << index;
    EXPECT_NE(read_file(folder_ / "out/b.html").find("\"trees\":[{\"kind\":\"start\""),
              std::string::npos);
}

TEST_F(Gallery, NamesWhatItCannotReadWithoutItsFolder) {
    const std::string trees = format_trees({"rrt", 3, {{"start", {{0.1, 0.3}}, {-1}}}, {}});
    const std::vector<std::array<std::string, 3>> cases{
        {"{}", "{}", "✗ b.trees.json:1:1: expected the integer 1 at version, found nothing"},
        {trees, "{", "✗ b.stats.json:1:2: expected JSON, found the end of the file"},
        {trees, "{\"planner\": 3}", "✗ b.stats.json:1:13: expected a string at planner, found 3"}};
    for (const auto& [tree_file, stats_file, reason] : cases) {
        const std::string index = index_beside(folder_.path(), tree_file, stats_file);
        EXPECT_NE(index.find("0 problems, 1 not readable"), std::string::npos) << index;
        EXPECT_NE(index.find(reason), std::string::npos) << index;
    }
}

TEST_F(Gallery, ThePageLoadsNothingFromElsewhere) {
    write_gallery(folder_ / "out", find_exhibits(std::vector{folder_ / "cases"}, std::nullopt));
    const std::string index = read_file(folder_ / "out/index.html");
    EXPECT_NE(index.find("Content-Security-Policy"), std::string::npos);
    EXPECT_NE(index.find("default-src 'none'"), std::string::npos);
    EXPECT_EQ(index.find("script"), std::string::npos);
}

TEST_F(Gallery, NoTwoExhibitsAndNoPageShareAFile) {
    const std::vector<ExhibitFiles> exhibits{{"index.txt"}, {"a.txt"}, {"x/a.txt"}, {"a-2.txt"}};
    EXPECT_EQ(gallery_names(exhibits), (std::vector<std::string>{"index-2", "a", "a-2", "a-2-2"}));
    EXPECT_EQ(gallery_files("g", exhibits).size(), 21U);
}

TEST_F(Gallery, AMapIsNotOverwritten) {
    std::filesystem::create_directory(folder_ / "out");
    std::ofstream(folder_ / "out/s.html") << "00\n";
    std::ofstream(folder_ / "out/s.json")
        << R"({"version": 1, "body": {"kind": "point"}, "map": {"file": "s.html"},)"
        << R"( "start": [0.5, 0.5], "goal": [1.5, 0.5]})";
    const std::vector<ExhibitFiles> exhibits{{folder_ / "out/s.json"}};
    const GalleryReport report = write_gallery(folder_ / "out", exhibits);
    ASSERT_EQ(report.failures.size(), 1U);
    EXPECT_EQ(read_file(folder_ / "out/s.html"), "00\n");
}

TEST_F(Gallery, AFolderThatCannotBeMadeIsAWriteError) {
    const std::vector<ExhibitFiles> none;
    EXPECT_THROW(write_gallery(folder_ / "cases/b.txt/out", none), WriteError);
}

}  // namespace
}  // namespace asv::io
