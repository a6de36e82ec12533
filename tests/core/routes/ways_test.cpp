#include "core/routes/ways.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "core/bounds/lower_bound.hpp"
#include "core/solve/solve.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/chains/two_doors.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

std::vector<Way> first_ways(const Problem& problem, std::size_t most) {
    Ways ways(problem);
    std::vector<Way> found;
    while (found.size() < most) {
        const auto way = ways.next();
        if (!way) break;
        found.push_back(*way);
    }
    return found;
}

bool closes(const Way& way, const Box& gate) {
    return std::find(way.closed.begin(), way.closed.end(), gate) != way.closed.end();
}

TEST(Ways, BeginWithNothingClosedAndTheBoundOfTheProblem) {
    const Problem problem = test::two_doors();
    const std::vector<Way> found = first_ways(problem, 1);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_TRUE(found[0].closed.empty());
    // The bound of the problem leaves out what the tolerance allows at both ends.
    EXPECT_NEAR(found[0].bound, cost_lower_bound(problem).total, 1e-3);
}

TEST(Ways, GoThroughTheOtherDoorWhereTheNearOneIsClosed) {
    const std::vector<Way> found = first_ways(test::two_doors(), 100);
    const auto through_far_door = std::find_if(
        found.begin(), found.end(), [](const Way& way) { return closes(way, test::near_door); });
    ASSERT_NE(through_far_door, found.end());
    EXPECT_GT(through_far_door->bound, found[0].bound + 0.5);
    for (const Way& way : found)
        EXPECT_FALSE(closes(way, test::near_door) && closes(way, test::far_door));
}

TEST(Ways, ComeInTheOrderOfTheirBoundsEachOnceAndLeaveTheEndsFree) {
    test::for_seeds(5, [](Rng& rng) {
        const Problem problem = test::cluttered(rng, 4, 12, 0.2);
        const std::vector<Way> found = first_ways(problem, 30);
        ASSERT_FALSE(found.empty());
        for (std::size_t i = 1; i < found.size(); ++i) {
            EXPECT_LE(found[i - 1].bound, found[i].bound);
            for (std::size_t j = 0; j < i; ++j) EXPECT_NE(found[i].closed, found[j].closed);
            const Problem closed = with_closed_gates(problem, found[i].closed);
            EXPECT_EQ(closed.obstacles.size(), problem.obstacles.size() + found[i].closed.size());
            EXPECT_TRUE(invalid_ends(closed).empty());
        }
    });
}

TEST(Ways, AreOneAmongVeryManyBoxes) {
    Rng rng(1);
    const std::vector<Way> found = first_ways(test::cluttered(rng, 3, 300, 0.02), 5);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].bound, 0);
}

}  // namespace
}  // namespace asv::core
