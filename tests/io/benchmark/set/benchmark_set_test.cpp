#include "io/benchmark/set/benchmark_set.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "io/text/atomic_file.hpp"

namespace asv::io {
namespace {

const std::string titles = "name,words,n,feasible,best_cost,lower_bound\n";

TEST(BenchmarkSet, IsTheFileInTheTree) {
    EXPECT_EQ(format_set(benchmark_set()), read_file(ASV_SOURCE_DIR "/testcases/set/problems.csv"));
}

TEST(BenchmarkSet, HasThreeHundredProblemsOfDifferentNamesAndWords) {
    std::set<std::string> names, words;
    for (const SetProblem& problem : benchmark_set()) {
        EXPECT_TRUE(names.insert(problem.name).second) << problem.name;
        EXPECT_TRUE(words.insert(problem.words).second) << problem.words;
        EXPECT_TRUE(problem.name.starts_with(problem.family())) << problem.name;
    }
    EXPECT_EQ(names.size(), 300U);
}

/// Two ASVs have no problem: they enclose no area.
TEST(BenchmarkSet, HasEveryFamilyAndEveryNumberOfAsvs) {
    std::set<std::string_view> families;
    std::set<std::size_t> counts;
    for (const SetProblem& problem : benchmark_set()) {
        families.insert(problem.family());
        if (problem.feasible) counts.insert(problem.asv_count);
    }
    EXPECT_EQ(families, (std::set<std::string_view>{"corridor", "bend", "gauntlet", "rooms", "maze",
                                                    "spiral", "crossing", "clutter"}));
    for (std::size_t n = 1; n <= 50; ++n) EXPECT_EQ(counts.contains(n), n != 2) << n;
    EXPECT_EQ(*counts.rbegin(), 50U);
}

TEST(BenchmarkSet, KnowsACostAndABoundOfEveryProblemThatHasAPath) {
    for (const SetProblem& problem : benchmark_set()) {
        ASSERT_EQ(problem.best_cost.has_value(), problem.feasible) << problem.name;
        ASSERT_EQ(problem.lower_bound.has_value(), problem.feasible) << problem.name;
        if (!problem.feasible) continue;
        EXPECT_GT(*problem.lower_bound, 0) << problem.name;
        EXPECT_GE(*problem.best_cost, *problem.lower_bound) << problem.name;
    }
}

TEST(BenchmarkSet, APatternFitsNamesAndFamilies) {
    const auto all_of = [](const std::string& pattern, const auto& belongs) {
        const std::vector<SetProblem> chosen = chosen_of_set(pattern);
        EXPECT_FALSE(chosen.empty()) << pattern;
        EXPECT_TRUE(std::all_of(chosen.begin(), chosen.end(), belongs)) << pattern;
        return chosen.size();
    };
    EXPECT_EQ(chosen_of_set("*").size(), benchmark_set().size());
    const std::size_t mazes =
        all_of("maze", [](const SetProblem& problem) { return problem.family() == "maze"; });
    EXPECT_EQ(chosen_of_set("maze*").size(), mazes);
    all_of("*-turned", [](const SetProblem& problem) { return !problem.feasible; });
    all_of("corridor-0[35]*", [](const SetProblem& problem) {
        return problem.asv_count == 3 || problem.asv_count == 5;
    });
    EXPECT_TRUE(chosen_of_set("labyrinth").empty());
    EXPECT_TRUE(chosen_of_set("").empty());
}

TEST(BenchmarkSet, ALineTellsAllOfAProblem) {
    const auto set =
        parse_set(titles + "a,maze -n 5,5,feasible,1.5,0.25\nb,maze -n 4,4,infeasible,,\n");
    ASSERT_EQ(set.size(), 2U);
    EXPECT_EQ(set[0].name, "a");
    EXPECT_EQ(set[0].words, "maze -n 5");
    EXPECT_EQ(set[0].family(), "maze");
    EXPECT_EQ(set[0].asv_count, 5U);
    EXPECT_EQ(set[0].best_cost, 1.5);
    EXPECT_EQ(set[0].lower_bound, 0.25);
    EXPECT_FALSE(set[1].feasible);
    EXPECT_FALSE(set[1].best_cost);
    EXPECT_EQ(set[1].line, "b,maze -n 4,4,infeasible,,");
}

TEST(BenchmarkSet, ALineThatIsNoProblemIsTold) {
    for (const std::string line :
         {"", "a", "a,maze,5,feasible,1", ",maze,5,feasible,1,1", "a,,5,feasible,1,1",
          "a,maze,,feasible,1,1", "a,maze,five,feasible,1,1", "a,maze,5,perhaps,1,1",
          "a,maze,5,feasible,1x,1", "a,maze,5,feasible,1,1,1"}) {
        try {
            parse_set(titles + line + "\nb,maze -n 4,4,infeasible,,\n");
            ADD_FAILURE() << line;
        } catch (const std::invalid_argument& error) {
            EXPECT_NE(std::string(error.what()).find(line), std::string::npos) << error.what();
        }
    }
    EXPECT_THROW(parse_set(""), std::invalid_argument);
}

}  // namespace
}  // namespace asv::io
