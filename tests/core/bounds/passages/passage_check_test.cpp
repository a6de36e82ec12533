#include "core/bounds/passages/passage_check.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/generate/families.hpp"
#include "core/solve/solve.hpp"
#include "core/validation/validate.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using test::mirrored;
using test::reversed;
using test::transposed;

constexpr const char* no_other_way = ", and there is no other way";

std::string said_of(std::size_t asv_count, const std::string& places) {
    return "no chain of " + std::to_string(asv_count) + " ASVs can have its middle " + places +
           no_other_way;
}

/// A corridor of a share of min_flat_height between obstacles 1 and 2, and of a share of the
/// chain's length.
Problem short_corridor(std::size_t asv_count, double height, double length,
                       std::uint64_t seed = 1) {
    CorridorOptions options;
    options.chain.asv_count = asv_count;
    options.height.factor = height;
    options.length = length * 0.05 * static_cast<double>(asv_count - 1);
    Rng rng(seed);
    return corridor(options, rng);
}

void expect_closed(const Problem& problem, const std::string& reason) {
    const Feasibility found = check_passages(problem);
    EXPECT_EQ(found.cause, Infeasibility::gates_closed);
    EXPECT_TRUE(found.proven_infeasible());
    EXPECT_EQ(found.reason, reason);
    EXPECT_FALSE(found.closed.empty());
}

TEST(PassageCheck, ClosesCorridorsThatAreShorterThanTheChain) {
    for (const std::size_t n : {3u, 4u, 5u, 6u}) {
        const Problem problem = short_corridor(n, 0.7, 0.9);
        const std::string reason = said_of(n, "between obstacles 1 and 2");
        expect_closed(problem, reason);
        expect_closed(mirrored(problem), reason);
        expect_closed(reversed(problem), reason);
        expect_closed(transposed(problem), reason);
        Problem backwards = problem;
        for (auto* state : {&backwards.start, &backwards.goal}) std::ranges::reverse(*state);
        expect_closed(backwards, reason);
    }
}

TEST(PassageCheck, FindsNothingWhereTheChainHooksThrough) {
    for (const std::size_t n : {4u, 6u, 7u}) {
        const Problem problem = short_corridor(n, 0.9, 0.6);
        EXPECT_EQ(check_passages(problem).cause, Infeasibility::none) << n << " ASVs";
        PassageCheck check(problem);
        check.work(10'000'000);
        EXPECT_TRUE(check.finished()) << "the gate is open";
    }
}

/// A wall across the square with a corridor of each height.
Problem two_doors(double lower, double upper) {
    Problem problem = short_corridor(4, 0.7, 0.9);
    const double left = problem.obstacles[0].low.x, right = problem.obstacles[0].high.x;
    problem.obstacles = {{{left, 0}, {right, 0.3}},
                         {{left, 0.3 + lower}, {right, 0.6}},
                         {{left, 0.6 + upper}, {right, 1}}};
    return problem;
}

TEST(PassageCheck, AllWaysHaveToBeClosed) {
    expect_closed(two_doors(0.008, 0.009),
                  said_of(4, "between obstacles 2 and 3 or between obstacles 1 and 2"));
    EXPECT_EQ(check_passages(two_doors(0.008, 0.02)).cause, Infeasibility::none);
    EXPECT_EQ(check_passages(two_doors(0.02, 0.009)).cause, Infeasibility::none);
}

TEST(PassageCheck, NamesTheBorder) {
    Problem problem = short_corridor(4, 0.7, 0.9);
    const Box block = problem.obstacles[0];
    problem.obstacles = {{{block.low.x, 0.01}, {block.high.x, 1}}};
    expect_closed(problem, said_of(4, "between obstacle 1 and the lower border"));
    expect_closed(transposed(problem), said_of(4, "between obstacle 1 and the left border"));
    problem.obstacles = {{{block.low.x, 0}, {block.high.x, 0.99}}};
    expect_closed(problem, said_of(4, "between obstacle 1 and the upper border"));
    expect_closed(transposed(problem), said_of(4, "between obstacle 1 and the right border"));
}

TEST(PassageCheck, DoesNotNameWhatOnlyTheToleranceOpens) {
    Problem problem = short_corridor(4, 0.7, 0.9);
    problem.obstacles[1].low.y = problem.obstacles[0].high.y;
    const Feasibility found = check_passages(problem);
    EXPECT_EQ(found.cause, Infeasibility::gates_closed);
    EXPECT_EQ(found.reason, "obstacles separate the middle of the chain from its goal");
}

TEST(PassageCheck, SeesWallsOfSeveralObstacles) {
    Problem problem = short_corridor(4, 0.7, 0.9);
    const Box upper = problem.obstacles[1];
    const double middle = geometry::centre(upper).x;
    // They overlap, so that there is no slit between them.
    problem.obstacles[1].high.x = middle + 0.005;
    problem.obstacles.push_back({{middle - 0.005, upper.low.y}, upper.high});
    const Feasibility found = check_passages(problem);
    EXPECT_EQ(found.cause, Infeasibility::gates_closed);
}

/// A corridor with two bends, to the one side and then to the other.
Problem two_bends(std::size_t asv_count, double height, std::uint64_t seed = 1) {
    BendOptions options;
    options.chain.asv_count = asv_count;
    options.height.factor = height;
    Rng rng(seed);
    return bend(options, rng);
}

void expect_no_room_to_turn(const Problem& problem) {
    PassageCheck check(problem);
    const Feasibility found = check.work(10'000'000);
    EXPECT_EQ(found.cause, Infeasibility::no_room_to_turn);
    EXPECT_TRUE(found.proven_infeasible());
    EXPECT_EQ(found.reason, "a chain of " + std::to_string(problem.asv_count()) +
                                " ASVs would have to turn where it has no room to");
    EXPECT_FALSE(found.closed.empty());
}

TEST(PassageCheck, SeesThatTwoBendsToDifferentSidesAreTooNarrow) {
    const Problem problem = two_bends(3, 1.6);
    expect_no_room_to_turn(problem);
    expect_no_room_to_turn(mirrored(problem));
    expect_no_room_to_turn(reversed(problem));
    expect_no_room_to_turn(transposed(problem));
    expect_no_room_to_turn(two_bends(4, 1.4));
    // The places where it would have to turn are in the upright part of the corridor.
    const Feasibility found = check_passages(problem);
    const Box &left = problem.obstacles[1], &right = problem.obstacles[2];
    for (const Box& place : found.closed) {
        EXPECT_GT(place.high.x, left.high.x - 0.02);
        EXPECT_LT(place.low.x, right.low.x + 0.02);
    }
}

TEST(PassageCheck, SeesThatOneBendOrWideOnesCanBePassed) {
    PassageCheck wide(two_bends(3, 3));
    EXPECT_EQ(wide.work(10'000'000).cause, Infeasibility::none);
    EXPECT_TRUE(wide.finished());
    BendOptions options;
    options.chain.asv_count = 4;
    options.bends = 1;
    options.height.factor = 1.4;
    Rng rng(1);
    PassageCheck one(bend(options, rng));
    EXPECT_EQ(one.work(10'000'000).cause, Infeasibility::none);
    EXPECT_TRUE(one.finished());
}

TEST(PassageCheck, LeavesAloneWhatItDoesNotSpeakOf) {
    EXPECT_TRUE(PassageCheck(short_corridor(13, 0.7, 0.5)).finished()) << "too many ASVs";
    Problem point = test::testcase("3ASV.txt");
    point.start.resize(1);
    point.goal.resize(1);
    point.body = PointBody{};
    EXPECT_TRUE(PassageCheck(point).finished());
    Problem long_steps = short_corridor(4, 0.7, 0.9);
    long_steps.requirements.max_step = 0.05;
    EXPECT_TRUE(PassageCheck(long_steps).finished()) << "the chain may turn inside out in one step";
}

Problem narrow_problem_of(std::size_t asv_count, Rng& rng) {
    const std::uint64_t seed = rng.below(1000);
    if (rng.chance(0.5)) return two_bends(asv_count, rng.uniform(1, 3), seed);
    return short_corridor(asv_count, rng.uniform(0.4, 1), rng.uniform(0.5, 1), seed);
}

TEST(PassageCheck, NeverClosesWhatThePlannerPasses) {
    std::size_t solved = 0, closed = 0;
    test::for_seeds(10, [&](Rng& rng) {
        const Problem problem = narrow_problem_of(3 + rng.below(4), rng);
        const bool no_path = check_passages(problem).proven_infeasible();
        SolveOptions options;
        options.max_iterations = 500;
        options.optimize = 0;
        const bool path = solve(problem, options).solution.has_value();
        EXPECT_FALSE(no_path && path);
        solved += path;
        closed += no_path;
    });
    EXPECT_GT(solved, 0u);
    EXPECT_GT(closed, 0u);
}

}  // namespace
}  // namespace asv::core
