#include "core/solve/solve.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <stdexcept>

#include "tests/kit/chains/problems.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/solving.hpp"

namespace asv::core {
namespace {

using test::expect_solved;
using test::plain;
using test::Points;
using test::ring;
using test::scaled;
using test::testcase;

struct EachTestcase : ::testing::TestWithParam<const char*> {};

TEST_P(EachTestcase, IsSolved) {
    const Problem problem = testcase(GetParam());
    for (std::uint64_t seed = 1; seed <= scaled(3); ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        expect_solved(problem, solve(problem, plain(seed)));
    }
}

INSTANTIATE_TEST_SUITE_P(Testcases, EachTestcase,
                         ::testing::Values("3ASV.txt", "3ASV-x4.txt", "3ASV-spiral.txt",
                                           "3ASV-clutter-20.txt", "3ASV-clutter-100.txt",
                                           "7ASV.txt", "7ASV-x2.txt", "7ASV-x4.txt", "7ASV-x6.txt",
                                           "15ASV-x4.txt", "15ASV-x6.txt"),
                         [](const auto& given) {
                             std::string label = given.param;
                             std::erase_if(label, [](char c) { return std::isalnum(c) == 0; });
                             return label;
                         });

/// Points of the unit square to points of the unit square.
struct Image {
    const char* label;
    Point (*map)(Point);
    bool other_way = false;  ///< along the chain
    bool swapped = false;    ///< start and goal
};

const Image images[] = {
    {"Transposed",
     [](Point p) {
         return Point{p.y, p.x};
     }},
    {"Mirrored",
     [](Point p) {
         return Point{1 - p.x, p.y};
     }},
    {"Turned",
     [](Point p) {
         return Point{1 - p.y, p.x};
     }},
    {"OtherWayAlongTheChain", [](Point p) { return p; }, true},
    {"StartAndGoalSwapped", [](Point p) { return p; }, false, true},
};

Problem image_of(Problem problem, const Image& image) {
    for (Points* points : {&problem.start, &problem.goal}) {
        for (Point& p : *points) p = image.map(p);
        if (image.other_way) *points = test::reversed(*points);
    }
    if (image.swapped) std::swap(problem.start, problem.goal);
    for (Box& box : problem.obstacles)
        box = geometry::bounds(geometry::Segment{image.map(box.low), image.map(box.high)});
    return problem;
}

struct EachImage : ::testing::TestWithParam<Image> {};

TEST_P(EachImage, IsSolvedAsWell) {
    for (const char* file : {"3ASV.txt", "7ASV.txt", "15ASV-x6.txt"}) {
        SCOPED_TRACE(file);
        const Problem problem = image_of(testcase(file), GetParam());
        for (std::uint64_t seed = 1; seed <= scaled(2); ++seed)
            expect_solved(problem, solve(problem, plain(seed)));
    }
}

/// Iterations that the search takes with each of so many seeds.
std::vector<std::size_t> iterations(const Problem& problem, std::uint64_t seeds) {
    std::vector<std::size_t> counts;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        const SolveResult result = solve(problem, plain(seed));
        EXPECT_EQ(result.status, SolveStatus::solved) << "seed " << seed;
        counts.push_back(result.statistics.iterations);
    }
    return counts;
}

/// The share of runs that a budget of iterations solves does not depend on how the problem lies.
TEST_P(EachImage, IsSolvedAsSoonButForChance) {
    const std::uint64_t seeds = scaled(60);
    for (const char* file : {"3ASV-x4.txt", "7ASV-x2.txt"}) {
        SCOPED_TRACE(file);
        const Problem problem = testcase(file);
        std::vector<std::size_t> original = iterations(problem, seeds);
        const auto middle = original.begin() + static_cast<std::ptrdiff_t>(seeds / 2);
        std::nth_element(original.begin(), middle, original.end());
        const std::size_t budget = *middle;
        const auto solved = [budget](const std::vector<std::size_t>& counts) {
            return static_cast<double>(
                std::ranges::count_if(counts, [budget](std::size_t n) { return n <= budget; }));
        };
        // Four standard deviations of the difference of two counts with a chance of a half.
        const double chance = 4 * std::sqrt(0.5 * static_cast<double>(seeds));
        EXPECT_NEAR(solved(iterations(image_of(problem, GetParam()), seeds)), solved(original),
                    chance)
            << "of " << seeds << " within " << budget << " iterations";
    }
}

INSTANTIATE_TEST_SUITE_P(Solve, EachImage, ::testing::ValuesIn(images),
                         [](const auto& given) { return std::string(given.param.label); });

TEST(Solve, SameSeedSamePath) {
    for (const char* planner : {"auto", "rrt-connect"}) {
        const Problem problem = testcase("3ASV.txt");
        SolveOptions options = plain(7);
        options.planner = planner_named(planner);
        const auto first = solve(problem, options), second = solve(problem, options);
        ASSERT_TRUE(first.solution && second.solution);
        EXPECT_EQ(first.solution->path, second.solution->path);
        EXPECT_EQ(first.solution->cost, second.solution->cost);
        options.seed = 8;
        EXPECT_NE(solve(problem, options).solution->path, first.solution->path);
    }
}

TEST(Solve, ReversePlansFromTheGoal) {
    const Problem problem = testcase("7ASV.txt");
    SolveOptions options = plain(1);
    options.reverse = true;
    options.keep_trees = true;
    const SolveResult result = solve(problem, options);
    expect_solved(problem, result);
    ASSERT_EQ(result.trees.size(), 2U);
    // The trees are told in the order of start and goal all the same: their roots lie there.
    const auto centroid = [](const Points& points) {
        Point sum{0, 0};
        for (const Point& p : points) sum = {sum.x + p.x, sum.y + p.y};
        const auto n = static_cast<double>(points.size());
        return Point{sum.x / n, sum.y / n};
    };
    const Point near_start = centroid(problem.start), near_goal = centroid(problem.goal);
    const auto off = [](Point a, Point b) { return std::hypot(a.x - b.x, a.y - b.y); };
    EXPECT_LT(off(result.trees[0].points[0], near_start),
              off(result.trees[0].points[0], near_goal));
    EXPECT_LT(off(result.trees[1].points[0], near_goal),
              off(result.trees[1].points[0], near_start));
}

TEST(Solve, TreesAreKeptWhenAskedFor) {
    const Problem problem = testcase("7ASV.txt");
    SolveOptions options = plain(1);
    EXPECT_TRUE(solve(problem, options).trees.empty());
    options.keep_trees = true;
    const SolveResult result = solve(problem, options);
    ASSERT_EQ(result.trees.size(), 2U);
    for (std::size_t side : {0U, 1U}) {
        const TreePicture& tree = result.trees[side];
        EXPECT_EQ(tree.points.size(), result.statistics.tree_nodes[side]);
        ASSERT_EQ(tree.points.size(), tree.parents.size());
        EXPECT_EQ(tree.parents[0], -1);
        for (std::size_t i = 1; i < tree.parents.size(); ++i)
            ASSERT_LT(tree.parents[i], static_cast<std::int64_t>(i));
    }
}

TEST(Solve, ImprovingNeverCostsMore) {
    const Problem problem = testcase("7ASV-x4.txt");
    SolveOptions options = plain(1);
    const SolveResult first = solve(problem, options);
    options.optimize = 0.3;
    const SolveResult better = solve(problem, options);
    expect_solved(problem, better);
    EXPECT_LT(better.statistics.cost, first.statistics.cost);
    const auto& history = better.statistics.cost_history;
    ASSERT_GE(history.size(), 2U);
    EXPECT_EQ(history.front().second, better.statistics.cost_first);
    for (std::size_t i = 1; i < history.size(); ++i) {
        EXPECT_LT(history[i].second, history[i - 1].second);
        EXPECT_GE(history[i].first, history[i - 1].first);
    }
}

TEST(Solve, ThreadsRaceToOneValidPath) {
    const Problem problem = testcase("7ASV.txt");
    SolveOptions options = plain(1);
    options.threads = 4;
    expect_solved(problem, solve(problem, options));
}

TEST(Solve, OneAsvIsAPoint) {
    Problem problem = test::problem({{0.1, 0.5}}, {{0.9, 0.5}});
    problem.obstacles = {{{0.3, 0}, {0.35, 0.9}}, {{0.6, 0.1}, {0.65, 1}}};
    for (const char* planner : {"auto", "rrt-connect"}) {
        SolveOptions options = plain(1);
        options.planner = planner_named(planner);
        const SolveResult result = solve(problem, options);
        expect_solved(problem, result);
        EXPECT_GE(result.statistics.cost, 1.5);
    }
}

TEST(Solve, StartThatIsTheGoal) {
    Problem problem = test::problem(ring(5, {0.5, 0.5}, 0), ring(5, {0.5, 0.5}, 0));
    const SolveResult result = solve(problem, plain(1));
    expect_solved(problem, result);
    EXPECT_LE(result.solution->cost, 1e-9);
}

TEST(Solve, EndsWhenItsTimeIsOver) {
    SolveOptions options = plain(1);
    options.time_limit = 1e-4;
    const SolveResult result = solve(testcase("15ASV.txt"), options);
    EXPECT_EQ(result.status, SolveStatus::timeout);
    EXPECT_FALSE(result.solution);
    EXPECT_FALSE(result.reason.empty());
}

TEST(Solve, EndsAfterItsIterations) {
    SolveOptions options = plain(1);
    options.max_iterations = 1;
    const SolveResult result = solve(testcase("7ASV.txt"), options);
    EXPECT_EQ(result.status, SolveStatus::timeout);
    EXPECT_EQ(result.statistics.iterations, 1);
    EXPECT_EQ(result.reason, "no path found: " + std::string(name(Outcome::iterations)));
}

TEST(Solve, EndsWhenItIsStopped) {
    std::stop_source source;
    SolveOptions options = plain(1);
    options.stop = source.get_token();
    source.request_stop();
    const SolveResult result = solve(testcase("15ASV.txt"), options);
    EXPECT_EQ(result.status, SolveStatus::interrupted);
    EXPECT_FALSE(result.solution);
}

TEST(Solve, StoppedWhileItImprovesItKeepsThePath) {
    const Problem problem = testcase("3ASV.txt");
    std::stop_source source;
    SolveOptions options = plain(1);
    options.optimize = 1e6;
    options.stop = source.get_token();
    options.on_progress = [&](const SolveProgress& progress) {
        if (progress.cost) source.request_stop();
    };
    expect_solved(problem, solve(problem, options));
}

TEST(Solve, ProgressIsToldAndChangesNothing) {
    const Problem problem = testcase("7ASV.txt");
    SolveOptions options = plain(3);
    const SolveResult quiet = solve(problem, options);
    double last = 0;
    options.on_progress = [&](const SolveProgress& progress) {
        EXPECT_GE(progress.elapsed, last);
        last = progress.elapsed;
    };
    EXPECT_EQ(solve(problem, options).solution->path, quiet.solution->path);
}

TEST(Solve, OneOptionsObjectServesManyCallsSinceTheClockStartsWithEach) {
    const Problem problem = testcase("3ASV-x4.txt");
    SolveOptions options = plain(1);
    options.time_limit = 0.3;
    std::this_thread::sleep_for(std::chrono::duration<double>(1.2 * options.time_limit));
    const SolveResult first = solve(problem, options);
    ASSERT_EQ(first.status, SolveStatus::solved);
    EXPECT_EQ(solve(problem, options).solution->path, first.solution->path);
}

TEST(Solve, WhatTheCallerSpentBeforeCountsTowardTheLimitAndTheTimes) {
    const Problem problem = testcase("3ASV-x4.txt");
    SolveOptions options = plain(1);
    options.time_limit = 5;
    options.elapsed_before = 2;
    const SolveResult solved = solve(problem, options);
    EXPECT_GE(solved.statistics.time_to_first, 2);
    EXPECT_GE(solved.statistics.time_total, 2);
    options.elapsed_before = 6;
    EXPECT_EQ(solve(testcase("15ASV.txt"), options).status, SolveStatus::timeout);
}

}  // namespace
}  // namespace asv::core
