#include "io/player/player.hpp"

#include <bit>
#include <cmath>
#include <fstream>
#include <random>
#include <sstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/player/gallery.hpp"
#include "io/player/packing.hpp"
#include "io/problem/problem_file.hpp"
#include "io/solution/solution_file.hpp"
#include "io/text/parse_error.hpp"
#include "tests/kit/drawing_samples.hpp"
#include "tests/kit/temporary_folder.hpp"

namespace asv::io {
namespace {

using nlohmann::json;
using test::Box;
using test::Point;
using test::sample;

TEST(Packing, Base64HasTheVectorsOfRfc4648) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64(std::string("\xFB\xFF\xFE\x00", 4)), "+//+AA==");
}

TEST(Packing, ATableComesBackToHalfAUnit) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        std::mt19937 random(seed);
        std::normal_distribution<double> normal;
        const double size = std::pow(10, 8 * normal(random));
        const std::size_t columns = 1 + seed % 5;
        std::vector<double> numbers(columns * (seed % 7) * 11);
        for (double& number : numbers) number = size * normal(random);
        const PackedTable table = pack_table(numbers, columns);
        const auto back = unpack_table(table, numbers.size() / columns, columns);
        double greatest = 1;
        for (const double number : numbers) greatest = std::max(greatest, std::abs(number));
        EXPECT_NEAR(table.unit, 1e-10 * greatest, 1e-22 * greatest);
        ASSERT_EQ(back.size(), numbers.size());
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            ASSERT_NEAR(back[i], numbers[i], 0.5000001 * table.unit) << "seed " << seed;
        }
    }
}

TEST(Packing, TakesTheGreatestNumbersThereAre) {
    const std::vector<double> numbers{1.7e308, -1.7e308, 1.7e308, -1.7e308, 0};
    const auto back = unpack_table(pack_table(numbers, 1), 5, 1);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(back[i] / 1.7e308, numbers[i] / 1.7e308, 1e-9);
}

TEST(Packing, RejectsATextOfAnotherShape) {
    const PackedTable table = pack_table(std::vector<double>{1, 2, 3, 4}, 2);
    EXPECT_THROW(unpack_table(table, 3, 2), std::invalid_argument);
    EXPECT_THROW(unpack_table(table, 1, 2), std::invalid_argument);
    EXPECT_THROW(unpack_table({1, "!"}, 1, 1), std::invalid_argument);
}

json data_of(const std::string& page) {
    const std::string mark = "<script id=\"data\" type=\"application/json\">";
    const std::size_t begin = page.find(mark) + mark.size();
    return json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

std::string content(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::stringstream text;
    text << in.rdbuf();
    return text.str();
}

TEST(Player, CarriesThePathAndTheExactReadOuts) {
    const Exhibit exhibit = make_exhibit(
        sample(5, {{0.1, 0.3}, {0.33, 0.37}}, {{{0.4, 0}, {0.5, 0.2}}, {{0.4, 0.6}, {0.5, 1}}}));
    const json data = data_of(make_player(exhibit));
    const std::size_t states = exhibit.measures.size();
    ASSERT_EQ(data["states"], states);
    const auto positions = unpack_table({data["unit"], data["positions"]}, states, 10);
    for (std::size_t i = 0; i < states; ++i) {
        for (std::size_t k = 0; k < 5; ++k) {
            ASSERT_NEAR(positions[10 * i + 2 * k], exhibit.solution->path.state(i)[k].x, 5.01e-11);
            ASSERT_NEAR(positions[10 * i + 2 * k + 1], exhibit.solution->path.state(i)[k].y,
                        5.01e-11);
        }
    }
    std::vector<double> costs;
    std::vector<double> clearances;
    for (const StateMeasures& measures : exhibit.measures) {
        costs.push_back(measures.cost);
        clearances.push_back(measures.clearance->distance);
    }
    EXPECT_EQ(data["cost"], pack_doubles(costs));
    EXPECT_EQ(data["clearance"], pack_doubles(clearances));
    EXPECT_TRUE(data["valid"]);
    EXPECT_EQ(data["totalCost"], exhibit.solution->cost);
    EXPECT_NEAR(exhibit.measures.back().cost, exhibit.solution->cost, 1e-9);
}

TEST(Player, IsOnePageThatNamesNoOtherPlace) {
    ExhibitInput input = sample(3, {{0.1, 0.3}, {0.2, 0.3}}, {});
    input.name = "</script><script>alert('@DATA@')</script>";
    const std::string page = make_player(make_exhibit(std::move(input)));
    for (const std::string_view part :
         {"http://", "https://", "src=", "@import", "url(", "fetch(", "XMLHttpRequest"}) {
        EXPECT_EQ(page.find(part), std::string::npos) << part;
    }
    EXPECT_EQ(page.find("<script>alert"), std::string::npos);
    EXPECT_EQ(data_of(page)["name"], "</script><script>alert('@DATA@')</script>");
}

TEST(Player, ListsTheViolationsOfTheValidator) {
    const Exhibit exhibit =
        make_exhibit(sample(3, {{0.1, 0.15}, {0.7, 0.15}}, {{{0.4, 0}, {0.5, 0.2}}}));
    const json data = data_of(make_player(exhibit));
    EXPECT_FALSE(data["valid"]);
    ASSERT_EQ(data["complaints"].size(), 1U);
    EXPECT_EQ(data["complaints"][0]["check"], "collisions");
    std::size_t failures = 0;
    for (const core::CheckResult& check : exhibit.report.checks) failures += check.failures;
    EXPECT_EQ(data["violations"].size(), failures);
    EXPECT_EQ(data["violations"][0]["obstacle"], 0);
}

TEST(Player, TenThousandStepsOfFifteenAsvsStayBelowFiveMegabytes) {
    // The way bends in every step, so that nothing is saved by straight lines.
    std::vector<Point> way;
    for (int i = 0; i <= 10000; ++i) {
        const double t = 0.004 * i;
        way.push_back({0.35 + 0.2 * std::cos(t), 0.3 + 0.2 * std::sin(t)});
    }
    const Exhibit exhibit = make_exhibit(sample(15, way, {{{0, 0}, {0.01, 1}}}));
    ASSERT_EQ(exhibit.measures.size(), 10001U);
    EXPECT_LT(make_player(exhibit).size(), 5000000U);
}

TEST(Player, ShowsTreesAndProblemsAlone) {
    ExhibitInput input = sample(3, {{0.1, 0.3}, {0.2, 0.3}}, {});
    input.solution.reset();
    input.trees = SearchTrees{"prm", 3, {{"roadmap", {{0, 0}, {1, 1}}, {-1, -1}}}, {{0, 1}}};
    const json data = data_of(make_player(make_exhibit(std::move(input))));
    EXPECT_EQ(data["states"], 0);
    EXPECT_EQ(data["trees"][0]["kind"], "roadmap");
    const std::vector<std::int32_t> edge{0, 1};
    EXPECT_EQ(data["trees"][0]["edges"], pack_integers(edge));
}

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

TEST_F(Gallery, WritesPicturesPlayersAndAnIndexOfAll) {
    const std::vector<std::filesystem::path> cases{folder_ / "cases", folder_ / "cases/b.txt"};
    const GalleryReport report = write_gallery(folder_ / "out", find_exhibits(cases, std::nullopt));
    EXPECT_EQ(report.shown, 3U);
    ASSERT_EQ(report.failures.size(), 1U);
    EXPECT_EQ(report.failures[0].name, "c");
    for (const char* name : {"a&a", "b", "b-2"}) {
        for (const char* ending : {".light.svg", ".dark.svg", ".html"}) {
            EXPECT_TRUE(std::filesystem::exists(folder_ / "out" / (std::string(name) + ending)))
                << name << ending;
        }
    }
    const std::string index = content(folder_ / "out/index.html");
    EXPECT_NE(index.find("href=\"a%26a.html\""), std::string::npos);
    EXPECT_NE(index.find(">a&amp;a</a>"), std::string::npos);
    EXPECT_NE(index.find("c.txt:1:1: expected"), std::string::npos);
    EXPECT_EQ(index.find(folder_.path().string()), std::string::npos) << "no folder names";
}

TEST_F(Gallery, AFolderThatCannotBeMadeIsAWriteError) {
    const std::vector<ExhibitFiles> none;
    EXPECT_THROW(write_gallery(folder_ / "cases/b.txt/out", none), WriteError);
}

}  // namespace
}  // namespace asv::io
