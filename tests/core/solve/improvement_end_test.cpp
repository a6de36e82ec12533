#include "core/solve/solve.hpp"
#include "tests/kit/chains/arms.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/solving.hpp"

/// What solve() says when the improvement has ended.

namespace asv::core {
namespace {

using test::expect_solved;
using test::plain;
using test::testcase;

TEST(Solve, EndsEarlyAndSaysSoWhereNothingIsLeftToGain) {
    Problem problem = testcase("3ASV.txt");
    problem.obstacles.clear();
    problem.goal = problem.start;
    for (geometry::Point& point : problem.goal) point.x += 0.2;
    SolveOptions options = plain(1);
    options.time_limit = 600;
    options.optimize = 500;
    const SolveResult result = solve(problem, options);
    expect_solved(problem, result);
    EXPECT_TRUE(result.statistics.optimal);
    EXPECT_NEAR(result.statistics.cost, 0.2 * 3, 1e-5);
}

TEST(Solve, NeverClaimsThatNothingIsLeftWhereThereIs) {
    SolveOptions options = plain(1);
    options.optimize = 0.05;
    for (const char* name : {"3ASV.txt", "7ASV.txt"}) {
        const SolveResult result = solve(testcase(name), options);
        EXPECT_FALSE(result.statistics.optimal) << name;
        EXPECT_GT(result.statistics.cost, 1.0001 * result.statistics.cost_lower_bound) << name;
    }
}

TEST(Solve, TheLastCostOfTheHistoryIsThatOfTheSolution) {
    Problem point = test::problem({{0.1, 0.5}}, {{0.9, 0.5}}, {{{0.4, 0.2}, {0.6, 0.9}}});
    point.body = PointBody{};
    Rng rng(1);
    for (const Problem& problem : {testcase("7ASV-x4.txt"), point, test::arm_problem(rng)}) {
        for (const unsigned threads : {1U, 3U}) {
            for (const double optimize : {0.0, 0.1}) {
                SolveOptions options = plain(1);
                options.threads = threads;
                options.optimize = optimize;
                const SolveResult result = solve(problem, options);
                expect_solved(problem, result);
                const SolveStatistics& spent = result.statistics;
                ASSERT_FALSE(spent.cost_history.empty());
                EXPECT_EQ(spent.cost_history.back().second, result.solution->cost);
                EXPECT_EQ(spent.cost, result.solution->cost);
                EXPECT_EQ(spent.cost_history.front().second, spent.cost_first);
            }
        }
    }
}

}  // namespace
}  // namespace asv::core
