#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "core/solve/solve.hpp"
#include "tests/kit/chains/chains.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/solving.hpp"

namespace asv::core {
namespace {

using test::plain;
using test::ring;
using test::testcase;

TEST(InvalidEnds, RefusesEndsThatAreNotValid) {
    Problem problem = test::problem(ring(5, {0.3, 0.3}, 0), ring(5, {0.7, 0.7}, 0));
    problem.goal[2].x += 0.01;
    ASSERT_FALSE(invalid_ends(problem).empty());
    for (const InvalidEnd& end : invalid_ends(problem)) EXPECT_TRUE(end.goal);
    try {
        solve(problem, plain(1));
        FAIL() << "solved";
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("goal"), std::string::npos);
    }
}

TEST(InvalidEnds, InvalidEndsSayWhatIsWrongAndWhere) {
    Problem problem = test::problem(ring(5, {0.3, 0.3}, 0), ring(5, {0.7, 0.7}, 0));
    EXPECT_TRUE(invalid_ends(problem).empty());
    problem.obstacles = {{{0.1, 0.1}, {0.2, 0.2}}, {{0.28, 0.1}, {0.32, 0.9}}};
    const auto found = invalid_ends(problem);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_FALSE(found[0].goal);
    EXPECT_NE(found[0].reason.find("obstacle 2"), std::string::npos) << found[0].reason;
}

TEST(InvalidEnds, InvalidEndsAreThrownWithEveryReason) {
    Problem problem = testcase("3ASV-x4.txt");
    problem.start[0].x += 0.001;
    problem.goal[2].y += 0.001;
    try {
        solve(problem);
        FAIL() << "invalid ends pass";
    } catch (const InvalidEnds& invalid) {
        ASSERT_GE(invalid.ends().size(), 2U);
        EXPECT_FALSE(invalid.ends().front().goal);
        EXPECT_TRUE(invalid.ends().back().goal);
        EXPECT_NE(std::string(invalid.what()).find("start is not valid: "), std::string::npos);
    }
}

}  // namespace
}  // namespace asv::core
