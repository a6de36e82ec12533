#include "core/solve/prepared_world.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "core/search/rng.hpp"
#include "core/validation/validate.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/solving.hpp"

namespace asv::core {
namespace {

using test::plain;
using test::testcase;

/// All that does not depend on a clock.
void expect_same(const SolveResult& result, const SolveResult& expected) {
    EXPECT_EQ(result.status, expected.status);
    EXPECT_EQ(result.reason, expected.reason);
    EXPECT_EQ(result.statistics.state_checks, expected.statistics.state_checks);
    ASSERT_EQ(result.solution.has_value(), expected.solution.has_value());
    if (!expected.solution) return;
    EXPECT_TRUE(result.solution->path == expected.solution->path);
    EXPECT_EQ(result.solution->cost, expected.solution->cost);
    EXPECT_EQ(result.statistics.cost_lower_bound, expected.statistics.cost_lower_bound);
    EXPECT_EQ(result.statistics.iterations, expected.statistics.iterations);
    EXPECT_EQ(result.corners.size(), expected.corners.size());
}

/// Between the ends of the problem both ways, and from the goal to itself.
std::vector<WorldQuery> queries_of(const Problem& problem) {
    const PlanarArm* arm = problem.arm();
    const Placement start{problem.start, arm ? arm->start : std::vector<double>{}};
    const Placement goal{problem.goal, arm ? arm->goal : std::vector<double>{}};
    return {{}, {goal, start}, {goal, {}}};
}

void expect_as_solve(const Problem& problem, const SolveOptions& options) {
    const PreparedWorld world(problem);
    for (const WorldQuery& query : queries_of(problem))
        expect_same(world.solve(query, options), solve(world.problem_of(query), options));
}

TEST(PreparedWorld, AnswersAsSolveDoesWhateverTheBody) {
    for (const char* file : {"3ASV.txt", "3ASV-clutter-100.txt", "15ASV-x6.txt",
                             "bodies/arm-3-plane.json", "bodies/point-town.json"}) {
        for (const std::uint64_t seed : {1U, 2U}) {
            SCOPED_TRACE(std::string(file) + ", seed " + std::to_string(seed));
            expect_as_solve(testcase(file), plain(seed));
        }
    }
}

TEST(PreparedWorld, AnswersAsSolveDoesWhateverThePlanner) {
    for (const auto name : planner_names()) {
        SCOPED_TRACE(name);
        SolveOptions options = plain(1);
        options.planner = planner_named(name);
        options.max_iterations = test::scaled(20'000);
        expect_as_solve(testcase("3ASV.txt"), options);
    }
}

TEST(PreparedWorld, AnswersAsSolveDoesReversedAndForClockwiseChains) {
    SolveOptions options = plain(1);
    options.reverse = true;
    expect_as_solve(testcase("3ASV.txt"), options);
    expect_as_solve(test::mirrored(testcase("3ASV.txt")), plain(1));
}

/// One world may hold chains of both orientations.
TEST(PreparedWorld, ServesBothOrientations) {
    Rng rng(1);
    const Problem one = test::cluttered(rng, 3, 60, 0.03);
    const PreparedWorld world(one);
    Problem other = one;
    std::reverse(other.start.begin(), other.start.end());
    std::reverse(other.goal.begin(), other.goal.end());
    const WorldQuery query{{other.start, {}}, {other.goal, {}}};
    expect_same(world.solve({}, plain(1)), solve(one, plain(1)));
    expect_same(world.solve(query, plain(1)), solve(other, plain(1)));
}

/// What is nearer to an end than the planner's margin leaves it a smaller one.
TEST(PreparedWorld, AnswersAsSolveDoesWhereAnObstacleIsCloseToAnEnd) {
    const std::vector<Box> far(20, Box{{0.001, 0.001}, {0.002, 0.002}});
    for (const double gap : {0.0, 3e-6, 1e-5, 1.1e-5}) {
        SCOPED_TRACE(gap);
        Problem problem = test::testcase("3ASV.txt");
        problem.obstacles.insert(problem.obstacles.end(), far.begin(), far.end());
        const auto left = std::ranges::min(problem.start, {}, &Point::x);
        problem.obstacles.push_back({{left.x - gap - 0.01, left.y - 0.01}, {left.x - gap, left.y}});
        ASSERT_TRUE(invalid_ends(problem).empty());
        // The obstacle pins the start, so that a search may be in vain; it is the same search.
        SolveOptions options = plain(1);
        options.max_iterations = 200;
        expect_as_solve(problem, options);
    }
}

TEST(PreparedWorld, FindsTheSameFaultsOfEnds) {
    Problem problem = testcase("3ASV.txt");
    const PreparedWorld world(problem);
    const auto shifted = [](std::vector<Point> points, const Point& by) {
        for (Point& point : points) point = {point.x + by.x, point.y + by.y};
        return points;
    };
    const Box box = problem.obstacles.at(0);
    const Point middle{(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2};
    const Point to_box{middle.x - problem.goal[0].x, middle.y - problem.goal[0].y};
    std::size_t found = 0;
    for (const Point& by : {Point{2, 0}, to_box}) {
        const WorldQuery query{{}, {shifted(problem.goal, by), {}}};
        const auto expected = invalid_ends(world.problem_of(query));
        ASSERT_FALSE(expected.empty());
        try {
            world.solve(query, plain(1));
        } catch (const InvalidEnds& invalid) {
            ++found;
            ASSERT_EQ(invalid.ends().size(), expected.size());
            for (std::size_t i = 0; i < expected.size(); ++i)
                EXPECT_EQ(invalid.ends()[i].reason, expected[i].reason);
        }
    }
    EXPECT_EQ(found, 2U);
}

TEST(PreparedWorld, RefusesQueriesOfAnotherBody) {
    const PreparedWorld chain(testcase("3ASV.txt"));
    EXPECT_THROW((void)chain.solve({{{{0.5, 0.5}}, {}}, {}}), std::invalid_argument);
    const PreparedWorld arm(testcase("bodies/arm-3-plane.json"));
    EXPECT_THROW((void)arm.solve({{{}, {0, 0}}, {}}), std::invalid_argument);
    EXPECT_THROW(PreparedWorld(Problem{}), std::invalid_argument);
}

/// Each corner is where a body may be, so that the next query can begin there.
TEST(PreparedWorld, CornersLeadFromStartToGoalThroughValidPlaces) {
    for (const char* file : {"3ASV.txt", "bodies/arm-3-plane.json", "bodies/point-town.json"}) {
        SCOPED_TRACE(file);
        const PreparedWorld world(testcase(file));
        for (const bool reverse : {false, true}) {
            SolveOptions options = plain(1);
            options.reverse = reverse;
            const SolveResult result = world.solve({}, options);
            ASSERT_TRUE(result.solution);
            ASSERT_GE(result.corners.size(), 2U);
            for (const Placement& corner : result.corners) {
                const Problem from_here = world.problem_of({corner, {}});
                EXPECT_TRUE(invalid_ends(from_here).empty());
            }
            const auto& [first, last] = std::pair(result.corners.front(), result.corners.back());
            for (std::size_t i = 0; i < first.points.size(); ++i) {
                EXPECT_NEAR(first.points[i].x, world.problem().start[i].x, 1e-12);
                EXPECT_NEAR(last.points[i].y, world.problem().goal[i].y, 1e-12);
            }
        }
    }
}

TEST(PreparedWorld, AnswersSeveralThreadsAtOnce) {
    const Problem problem = testcase("3ASV-clutter-100.txt");
    const PreparedWorld world(problem);
    const SolveResult forth = solve(problem, plain(1));
    const SolveResult back = solve(test::reversed(problem), plain(1));
    std::vector<std::jthread> threads;
    for (std::size_t thread = 0; thread < 4; ++thread)
        threads.emplace_back([&, thread] {
            const bool turned = thread % 2 == 1;
            for (int round = 0; round < 3; ++round)
                expect_same(world.solve(queries_of(problem)[turned ? 1 : 0], plain(1)),
                            turned ? back : forth);
        });
}

}  // namespace
}  // namespace asv::core
