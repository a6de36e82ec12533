#include "io/batch/query_file.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "io/problem/problem_file.hpp"
#include "io/text/atomic_file.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/files/mutated.hpp"
#include "tests/kit/files/temporary_folder.hpp"
#include "tests/kit/scaled.hpp"

namespace asv::io {
namespace {

std::vector<Query> queries_in(const std::string& content, const core::Problem& world) {
    const test::TemporaryFolder folder;
    write_file(folder / "q", content);
    QueryFile file(folder / "q", world);
    std::vector<Query> all;
    while (auto query = file.next()) all.push_back(*query);
    return all;
}

TEST(QueryFile, KnowsItsLines) {
    const auto all = queries_in("\xEF\xBB\xBF{\"id\": 1}\r\n\n \t\r\n{\"id\": \"\\u00e4\\\"\"}\n{}",
                                test::testcase("3ASV.txt"));
    ASSERT_EQ(all.size(), 3U);
    EXPECT_EQ(all[0].line, 1U);
    EXPECT_EQ(all[0].id, "1");
    EXPECT_EQ(all[0].error, "");
    EXPECT_EQ(all[1].line, 4U);
    EXPECT_EQ(all[1].id, "\"\u00e4\\\"\"");
    EXPECT_EQ(all[2].line, 5U);
    EXPECT_EQ(all[2].id, "");
    EXPECT_TRUE(all[2].ends.start.empty() && all[2].ends.goal.empty());
}

TEST(QueryFile, EndsAreThoseOfTheBody) {
    const auto chain = queries_in(
        "{\"start\": [[0, 0], [0.05, 0], [0.05, 0.05]]}\n"
        "{\"goal\": {\"at\": [0, 0], \"heading\": 90, \"turns\": [90]}}\n",
        test::testcase("3ASV.txt"));
    EXPECT_EQ(chain.at(0).ends.start.points.size(), 3U);
    EXPECT_EQ(chain.at(1).ends.goal.points.at(0), (geometry::Point{0, 0}));
    const auto arm =
        queries_in("{\"start\": [1, 0.5, 0.5]}\n{\"start\": [1, 0.5]}\n",
                   read_problem(test::testcase_file("bodies/arm-3-workshop.json")).problem);
    EXPECT_EQ(arm.at(0).ends.start.angles, (std::vector<double>{1, 0.5, 0.5}));
    EXPECT_NE(arm.at(1).error.find(":2:11: expected an array of 3 joint angles"), std::string::npos)
        << arm[1].error;
    const auto point =
        queries_in("{\"goal\": [20, 30]}\n",
                   read_problem(test::testcase_file("bodies/point-town.json")).problem);
    EXPECT_EQ(point.at(0).ends.goal.points, (std::vector<geometry::Point>{{20, 30}}));
}

TEST(QueryFile, AQueryThatIsTooLongSpoilsNoOther) {
    const auto all =
        queries_in(std::string(longest_query, ' ') + "{}\n{}\n", test::testcase("3ASV.txt"));
    ASSERT_EQ(all.size(), 2U);
    EXPECT_NE(all[0].error.find("expected at most 67108864 bytes in a line, found more"),
              std::string::npos)
        << all[0].error;
    EXPECT_EQ(all[1].error, "");
}

TEST(QueryFile, ABrokenQueryIsUnderstoodOrRefused) {
    const std::string query = R"({"id": 12, "start": [[0.1, 0.2], [0.15, 0.2], [0.15, 0.25]],)"
                              R"( "goal": {"shape": "arc", "at": [0.8, 0.2], "heading": 90}})";
    test::Random random(1);
    std::string content;
    for (std::size_t i = test::scaled(20'000); i > 0; --i)
        content += test::mutated(query, random) + '\n';
    const auto all = queries_in(content, test::testcase("3ASV.txt"));
    const auto understood =
        std::count_if(all.begin(), all.end(), [](const Query& each) { return each.error.empty(); });
    EXPECT_GT(understood, 0);
    EXPECT_LT(understood, static_cast<std::ptrdiff_t>(all.size()));
    for (const Query& each : all)
        for (const auto& end : {each.ends.start, each.ends.goal})
            for (const geometry::Point& point : end.points)
                ASSERT_TRUE(std::isfinite(point.x) && std::isfinite(point.y)) << each.line;
}

}  // namespace
}  // namespace asv::io
