#pragma once

#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "tests/kit/toy_spaces.hpp"

/// Planners on the toy space of a point, side by side in tests that ask the same of each.

namespace asv::test {

/// From one place of the unit square to another, with the wall of toy_spaces.hpp between them.
inline const Row start{0.1, 0.1}, goal{0.9, 0.1};

/// A planner that is asked for a way from start to goal.
struct ToyPlanner {
    std::string name;
    core::SearchResult (*plan)(PointSpace&, const core::Limits&, core::Rng&, const core::Observer&);

    friend void PrintTo(const ToyPlanner& which, std::ostream* out) { *out << which.name; }
};

/// A fixture of tests that each planner has to pass.
struct ToyPlannerTest : ::testing::TestWithParam<ToyPlanner> {
    core::SearchResult plan(PointSpace& space, std::uint64_t seed, const core::Limits& limits = {},
                            const core::Observer& observer = {}) const {
        core::Rng rng(seed);
        return GetParam().plan(space, limits, rng, observer);
    }
};

/// Asserts that the path leads from start to goal, and through no wall.
inline void expect_way(const PointSpace& space, const core::SearchResult& result) {
    ASSERT_EQ(result.outcome, core::Outcome::solved);
    EXPECT_EQ(Row(result.path.begin(), result.path.begin() + 2), start);
    EXPECT_EQ(Row(result.path.end() - 2, result.path.end()), goal);
    for (std::size_t i = 1; i < result.path.size() / 2; ++i)
        ASSERT_TRUE(space.free(nth(result.path, 2, i - 1), nth(result.path, 2, i)));
}

}  // namespace asv::test
