#include "io/solution/trees_file.hpp"

#include <string>

#include <gtest/gtest.h>

#include "io/solution/run_facts.hpp"
#include "io/text/json/place.hpp"
#include "io/text/parse_error.hpp"
#include "tests/kit/files/error_message.hpp"
#include "tests/kit/files/temporary_folder.hpp"

namespace asv::io {
namespace {

SearchTrees sample() {
    return {"auto",
            7,
            {{"start", {{0.1, 0.2}, {1.0 / 3, 1e-300}, {-0.0, 0.7}}, {-1, 0, 1}},
             {"goal", {{0.9, 0.9}}, {-1}}},
            {}};
}

TEST(TreesFile, ReadsBackWhatItWrites) {
    EXPECT_EQ(parse_trees(format_trees(sample()), "trees.json"), sample());
    const SearchTrees roadmap{"prm", 1, {{"roadmap", {{0, 0}, {1, 1}}, {-1, -1}}}, {{0, 1}}};
    const test::TemporaryFolder folder;
    write_trees(folder / "trees.json", roadmap);
    EXPECT_EQ(read_trees(folder / "trees.json"), roadmap);
}

TEST(TreesFile, MayLeaveOutParentsAndEdges) {
    const SearchTrees trees = parse_trees(
        R"({"version": 1, "planner": "prm", "asv_count": 3,
            "trees": [{"root": "roadmap", "points": [[0, 1], [2, 3]]}]})",
        "trees.json");
    EXPECT_EQ(trees.trees[0].parents, (std::vector<std::int64_t>{-1, -1}));
    EXPECT_TRUE(trees.edges.empty());
}

TEST(TreesFile, TakesParentsBehindTheirChildren) {
    const SearchTrees trees = parse_trees(
        R"({"version": 1, "planner": "rrt-star", "asv_count": 3,
            "trees": [{"root": "start", "points": [[0, 1], [2, 3]], "parents": [1, -1]}]})",
        "trees.json");
    EXPECT_EQ(trees.trees[0].parents[0], 1);
}

std::string complaint(const std::string& text) {
    return test::error_message<ParseError>([&] { parse_trees(text, "trees.json"); });
}

TEST(TreesFile, NamesThePlaceOfWhatItCannotTake) {
    const std::string head = R"({"version": 1, "planner": "p", "asv_count": 3, "trees": )";
    EXPECT_EQ(complaint(""), "trees.json:1:1: expected JSON, found the end of the file");
    EXPECT_EQ(complaint("{\n \"version\": oops}"), "trees.json:2:13: expected JSON, found \"o\"");
    EXPECT_EQ(complaint("[1]"), "trees.json:1:1: expected the integer 1 at version, found nothing");
    EXPECT_EQ(complaint(R"({"version": 2})"),
              "trees.json:1:13: expected the integer 1 at version, found 2");
    EXPECT_EQ(complaint(R"({"version": 1, "planner": "p", "asv_count": 0})"),
              "trees.json:1:45: expected an integer from 1 to 2147483647 at asv_count, found 0");
    EXPECT_EQ(complaint(head + "7}"), "trees.json:1:57: expected an array at trees, found 7");
    EXPECT_EQ(complaint(head + "\n[{\"root\": \"start\", \"points\": [[1, 2], [3]]}]}"),
              "trees.json:2:39: expected two numbers [x, y] at trees[0].points[1], found [3]");
    EXPECT_EQ(
        complaint(head + "\n[{\"root\": \"start\", \"points\": [[1, 2]], \"parents\": [1]}]}"),
        "trees.json:2:52: expected an integer from -1 to 0 at trees[0].parents[0], found 1");
    EXPECT_EQ(complaint(head + "[{\"root\": \"start\", \"points\": [], \"parents\": [-1]}]}"),
              "trees.json:1:101: expected as many numbers as there are points (0) at "
              "trees[0].parents, found [-1]");
    EXPECT_EQ(
        complaint(head + "[{\"root\": \"roadmap\", \"points\": [[0, 0]]}], \"edges\": [[0, 1]]}"),
        "trees.json:1:114: expected the integer 0 at edges[0][1], found 1");
    EXPECT_EQ(complaint(head + "[], \"edges\": [[0, 1]]}"),
              "trees.json:1:70: expected no edges without a tree at edges, found [[0,1]]");
    EXPECT_EQ(complaint(head + "[{\"root\": \"start\", \"points\": [[1e999, 2]]}]}"),
              "trees.json:1:88: expected a number within the range of a double, found 1e999");
}

TEST(TreesFile, APointIsTwoNumbersAndAnEdgeTwoIndices) {
    const std::string head = R"({"version": 1, "planner": "p", "asv_count": 3, "trees": )";
    for (const char* point : {"7", "[]", "[1]", "[1, 2, 3]", "[\"1\", 2]", "[1, null]"})
        EXPECT_TRUE(complaint(head + "[{\"root\": \"start\", \"points\": [" + point + "]}]}")
                        .starts_with("trees.json:1:87: expected two numbers [x, y] at "
                                     "trees[0].points[0], found "))
            << point;
    for (const char* edge : {"7", "[0]", "[0, 0, 0]"})
        EXPECT_TRUE(complaint(head +
                              "[{\"root\": \"roadmap\", \"points\": [[0, 0]]}], \"edges\": [" +
                              edge + "]}")
                        .starts_with("trees.json:1:110: expected two indices [i, j] at edges[0], "
                                     "found "))
            << edge;
}

TEST(TreesFile, TakesNoHugeIntegers) {
    EXPECT_NE(complaint(R"({"version": 18446744073709551615})"), "none");
    EXPECT_NE(complaint(R"({"version": 1.0})"), "none");
}

TEST(TreesFile, AMissingFileIsAReadError) {
    EXPECT_THROW(read_trees("/nonexistent/trees.json"), ReadError);
}

TEST(JsonPlace, FindsValuesThroughNestingStringsAndBlanks) {
    const std::string text =
        "{ \"a\": [1, {\"b\\\"]\": 0, \"b\" :\n  [true, \"x,]}\", -1e5]}], \"a/\": 3}";
    const auto place = [&](const char* pointer) {
        const TextPlace found = place_of_value(text, pointer);
        return std::to_string(found.line) + ":" + std::to_string(found.column);
    };
    EXPECT_EQ(place(""), "1:1");
    EXPECT_EQ(place("/a"), "1:8");
    EXPECT_EQ(place("/a/0"), "1:9");
    EXPECT_EQ(place("/a/1/b"), "2:3");
    EXPECT_EQ(place("/a/1/b/1"), "2:10");
    EXPECT_EQ(place("/a/1/b/2"), "2:18");
    EXPECT_EQ(place("/a/1/c/0"), "1:12") << "the deepest that exists";
    EXPECT_EQ(place("/a/0/x"), "1:9");
}

TEST(RunFacts, TakesWhatIsKnown) {
    const RunFacts known =
        parse_run_facts(R"({"planner": "rrt", "cost_lower_bound": 2.5})", "s.json");
    EXPECT_EQ(known.planner, "rrt");
    EXPECT_EQ(known.lower_bound, 2.5);
    EXPECT_FALSE(parse_run_facts(R"({"cost_lower_bound": null})", "s.json").lower_bound);
    EXPECT_FALSE(parse_run_facts(R"({"cost_lower_bound": 0})", "s.json").lower_bound);
    EXPECT_THROW(parse_run_facts(R"({"cost_lower_bound": "2"})", "s.json"), ParseError);
}

}  // namespace
}  // namespace asv::io
