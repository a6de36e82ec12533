#include "io/player/player.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "io/player/packing.hpp"
#include "tests/kit/files/drawing_samples.hpp"

namespace asv::io {
namespace {

using nlohmann::json;
using test::Box;
using test::Point;
using test::sample;

json data_of(const std::string& page) {
    const std::string mark = "<script id=\"data\" type=\"application/json\">";
    const std::size_t begin = page.find(mark) + mark.size();
    return json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

TEST(Player, CarriesThePathAndTheExactReadOuts) {
    const Exhibit exhibit = make_exhibit(
        sample(5, {{0.1, 0.3}, {0.33, 0.37}}, {{{0.4, 0}, {0.5, 0.2}}, {{0.4, 0.6}, {0.5, 1}}}));
    const json data = data_of(make_player(exhibit));
    const std::size_t states = exhibit.measures.size();
    ASSERT_EQ(data["states"], states);
    EXPECT_EQ(data["lastStep"], states - 1);
    EXPECT_EQ(data["steps"], "") << "all of them are there";
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
    EXPECT_EQ(data["violationCount"], failures);
    EXPECT_EQ(data["complaints"][0]["step"], exhibit.report.checks[7].worst->state);
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

TEST(Player, CarriesTheObstaclesHoweverMany) {
    std::vector<Box> boxes;
    std::vector<double> sides;
    for (int i = 0; i < 2000; ++i) {
        const double x = 0.5 + 0.0002 * i;
        boxes.push_back({{x, 0.9}, {x + 0.0001, 1}});
        sides.insert(sides.end(), {x, 0.9, x + 0.0001, 1});
    }
    const Exhibit exhibit = make_exhibit(sample(3, {{0.1, 0.3}, {0.2, 0.3}}, std::move(boxes)));
    const std::string element = "<script id=\"obstacles\" type=\"text/plain\">";
    EXPECT_NE(make_player(exhibit).find(element + pack_doubles(sides) + "</script>"),
              std::string::npos);
}

TEST(Player, TellsWhichEndOfAProblemIsNotValid) {
    ExhibitInput input = sample(3, {{0.1, 0.3}, {0.2, 0.3}}, {});
    input.solution.reset();
    const auto complaint_with = [&](const Box& box) {
        input.problem.obstacles = {box};
        const json data = data_of(make_player(make_exhibit(input)));
        EXPECT_EQ(data["verdict"], "start or goal is not valid");
        EXPECT_EQ(data["violationCount"], 0) << "there is no path that has a step";
        return data["complaints"].at(0)["sentence"].get<std::string>();
    };
    const auto around = [](const Point& p) {
        return Box{{p.x - 0.001, p.y - 0.001}, {p.x + 0.001, p.y + 0.001}};
    };
    EXPECT_TRUE(complaint_with(around(input.problem.start[0])).ends_with(" (start)"));
    EXPECT_TRUE(complaint_with(around(input.problem.goal[0])).ends_with(" (goal)"));
}

TEST(Player, TellsWhyThereIsNoPath) {
    const json data = data_of(make_player(make_exhibit(test::low_corridor())));
    EXPECT_FALSE(data["valid"]);
    EXPECT_EQ(data["verdict"], "there is no path");
    ASSERT_EQ(data["complaints"].size(), 1U);
    EXPECT_EQ(data["complaints"][0]["check"], "no path");
    EXPECT_TRUE(data["complaints"][0]["sentence"].get<std::string>().starts_with(
        "no chain of 3 ASVs passes the corridor between obstacles 1 and 2: "));
}

/// The links of an arm enclose nothing.
TEST(Player, OfAnArmTellsNoArea) {
    ExhibitInput input = sample(1, {{0.1, 0.3}, {0.2, 0.3}}, {});
    core::PlanarArm arm;
    arm.links = {0.2};
    arm.joints = {{.wraps = true}};
    arm.start = {0};
    arm.goal = {0};
    input.problem.start = input.problem.goal = {{0.1, 0.3}, {0.3, 0.3}};
    input.problem.body = arm;
    input.solution->path = core::Path(2);
    input.solution->path.push_back(input.problem.start);
    input.solution->cost = 0;
    const json data = data_of(make_player(make_exhibit(input)));
    EXPECT_EQ(data["body"], "arm");
    EXPECT_EQ(data["words"]["link"], "link");
    const std::vector<double> none{std::numeric_limits<double>::quiet_NaN()};
    EXPECT_EQ(data["area"], pack_doubles(none));
    EXPECT_EQ(data["clearance"], pack_doubles(none)) << "nothing is there to be near to";
}

TEST(Player, SpeaksOfTheBodyInItsOwnWords) {
    ExhibitInput input = sample(1, {{0.1, 0.3}, {0.2, 0.3}}, {});
    EXPECT_EQ(data_of(make_player(make_exhibit(input)))["words"]["link"], "broom");
    input.problem.body = core::PointBody{};
    const json words = data_of(make_player(make_exhibit(input)))["words"];
    EXPECT_EQ(words["link"], "") << "a point has no links";
    EXPECT_EQ(words["counted"], "");
    EXPECT_EQ(words["chain"], "point");
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

TEST(Player, ShowsTheTreeOfEachEndInItsOwnColour) {
    ExhibitInput input = sample(3, {{0.1, 0.3}, {0.2, 0.3}}, {});
    const auto tree = [](const char* root) { return SearchTree{root, {{0, 0}}, {-1}}; };
    input.trees = SearchTrees{"rrt-connect", 3, {tree("start"), tree("goal")}, {}};
    const json data = data_of(make_player(make_exhibit(std::move(input))));
    EXPECT_EQ(data["trees"][0]["kind"], "start");
    EXPECT_EQ(data["trees"][1]["kind"], "goal");
    EXPECT_EQ(data["trees"][1]["edges"], "");
}

}  // namespace
}  // namespace asv::io
