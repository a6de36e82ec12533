#include <string>
#include <utility>
#include <vector>

#include "tests/kit/chains/problems.hpp"
#include "tests/kit/solving.hpp"

/// Every planner, sampler and extension by its name, through solve().

namespace asv::core {
namespace {

using test::expect_solved;
using test::plain;
using test::testcase;

TEST(SolvePlanners, RrtConnectSolvesTheLighterOnes) {
    for (const char* file : {"3ASV.txt", "3ASV-x4.txt", "7ASV-x6.txt"}) {
        SCOPED_TRACE(file);
        const Problem problem = testcase(file);
        SolveOptions options = plain(1);
        options.planner = RrtConnectPlanner{};
        expect_solved(problem, solve(problem, options));
    }
}

TEST(SolvePlanners, EveryPlannerSolvesAnEasyOne) {
    const Problem problem = testcase("3ASV.txt");
    for (const auto planner : planner_names()) {
        SCOPED_TRACE(planner);
        SolveOptions options = plain(2);
        options.planner = planner_named(planner);
        options.keep_trees = true;
        const SolveResult result = solve(problem, options);
        expect_solved(problem, result);
        EXPECT_EQ(solve(problem, options).solution->path, result.solution->path);
        EXPECT_EQ(result.edges.empty(), planner.substr(0, 3) != "prm");
        ASSERT_FALSE(result.trees.empty());
        for (const auto& [a, b] : result.edges)
            ASSERT_LT(std::max(a, b), result.trees[0].points.size());
        EXPECT_EQ(result.trees.size(), planner == "auto" || planner == "rrt-connect" ? 2U : 1U);
        EXPECT_EQ(name(result.trees[0].root), result.edges.empty() ? "start" : "roadmap");
    }
}

TEST(SolvePlanners, EverySamplerServesEveryPlanner) {
    const Problem problem = testcase("3ASV.txt");
    for (const auto planner_name : planner_names()) {
        if (planner_name == "auto") continue;
        for (const auto* sampler : {"own", "uniform", "grid", "stepwise", "corridor", "mix"}) {
            SCOPED_TRACE(std::string(planner_name) + " " + sampler);
            SolveOptions options = plain(1);
            options.planner = planner_named(planner_name);
            set(options.planner, "sampler", sampler);
            set(options.planner, "mix-uniform", "1");
            set(options.planner, "mix-passage", "1");
            if (planner_name == "rrt-star") set(options.planner, "nodes", "300");
            expect_solved(problem, solve(problem, options));
        }
    }
}

TEST(SolvePlanners, RrtConnectSolvesWithEachExtension) {
    const Problem problem = testcase("3ASV.txt");
    for (const auto& [setting, value] : {std::pair{"swap-limiter", "on"},
                                         {"collision-swap", "on"},
                                         {"exhaustion", "plain"},
                                         {"exhaustion", "heuristic"},
                                         {"neighbour-cost", "on"},
                                         {"passage-filter", "on"},
                                         {"control-chosen", "on"},
                                         {"goal-bias", "on"}}) {
        SCOPED_TRACE(std::string(setting) + "=" + value);
        SolveOptions options = plain(1);
        options.planner = RrtConnectPlanner{};
        set(options.planner, setting, value);
        expect_solved(problem, solve(problem, options));
    }
}

TEST(SolvePlanners, RrtConnectSolvesBySingleSteps) {
    for (const char* file : {"3ASV.txt", "bodies/arm-4-map.json", "bodies/point-town.json"}) {
        SCOPED_TRACE(file);
        const Problem problem = testcase(file);
        SolveOptions options = plain(1);
        options.planner = RrtConnectPlanner{};
        set(options.planner, "extend", "steps");
        std::vector<std::size_t> nodes;
        for (const char* which : {"each", "last"}) {
            set(options.planner, "extend-nodes", which);
            const SolveResult result = solve(problem, options);
            expect_solved(problem, result);
            EXPECT_EQ(solve(problem, options).solution->path, result.solution->path);
            const SolveStatistics& spent = result.statistics;
            EXPECT_GT(spent.edge_checks, 300U);
            nodes.push_back(spent.tree_nodes[0] + spent.tree_nodes[1]);
        }
        EXPECT_GT(nodes[0], 300U);
        EXPECT_LT(5 * nodes[1], nodes[0]);
    }
}

TEST(SolvePlanners, RrtStarTellsWhenItsFirstPathWasThere) {
    const Problem problem = testcase("3ASV.txt");
    SolveOptions options = plain(1);
    options.planner = RrtStarPlanner{};
    const SolveStatistics spent = solve(problem, options).statistics;
    ASSERT_GE(spent.cost_history.size(), 2U);
    EXPECT_EQ(spent.cost_history.front().first, spent.time_to_first);
    EXPECT_EQ(spent.cost_history.front().second, spent.cost_first);
    for (std::size_t i = 1; i < spent.cost_history.size(); ++i)
        EXPECT_LT(spent.cost_history[i].second, spent.cost_history[i - 1].second);
}

}  // namespace
}  // namespace asv::core
