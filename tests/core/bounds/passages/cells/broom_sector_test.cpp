#include "core/bounds/passages/cells/broom_sector.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "core/search/rng.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

constexpr double shortest = 0.049, longest = 0.051;

Interval random_interval(Rng& rng, double widest) {
    const double low = rng.uniform(-4, 10);
    return {low, low + rng.uniform(0, widest)};
}

double inside(const Interval& interval, Rng& rng) {
    return rng.chance(0.2) ? interval.low : rng.uniform(interval.low, interval.high);
}

/// Is the point on one side of the line, or on it, for all corners on that side?
bool in_hull(const std::array<geometry::Point, 4>& corners, const geometry::Point& point) {
    for (double angle = 0; angle < 6.3; angle += 0.01) {
        const auto along = [&](const geometry::Point& p) {
            return p.x * std::cos(angle) + p.y * std::sin(angle);
        };
        double farthest = along(corners[0]);
        for (const auto& corner : corners) farthest = std::max(farthest, along(corner));
        if (along(point) > farthest + 1e-12) return false;
    }
    return true;
}

TEST(BroomSector, HoldsEveryBroomOfItsHeadings) {
    test::for_seeds(200, [](Rng& rng) {
        const Interval heading = random_interval(rng, 2);
        const BroomSector sector = broom_sector(heading, shortest, longest);
        EXPECT_EQ(sector.wide, width(heading) > 1.4);
        for (int i = 0; i < 5; ++i) {
            const double angle = inside(heading, rng), length = rng.uniform(shortest, longest);
            const geometry::Point broom{length * std::cos(angle), length * std::sin(angle)};
            EXPECT_TRUE(contains(grown(sector.box, 1e-12), broom));
            EXPECT_TRUE(sector.wide || in_hull(sector.corners, broom));
        }
    });
}

TEST(BroomSector, KnowsTheRangeOfTurns) {
    test::for_seeds(2000, [](Rng& rng) {
        const Interval a = random_interval(rng, rng.chance(0.5) ? 0.1 : 4);
        const Interval b = random_interval(rng, rng.chance(0.5) ? 0.1 : 4);
        const BroomSector from = broom_sector(a, shortest, longest);
        const BroomSector to = broom_sector(b, shortest, longest);
        const Interval sine = turn_sines(from, to), cosine = turn_cosines(from, to);
        for (int i = 0; i < 5; ++i) {
            const double turn = inside(b, rng) - inside(a, rng);
            EXPECT_GE(std::sin(turn), sine.low - 1e-12);
            EXPECT_LE(std::sin(turn), sine.high + 1e-12);
            EXPECT_GE(std::cos(turn), cosine.low - 1e-12);
            EXPECT_LE(std::cos(turn), cosine.high + 1e-12);
        }
    });
    // They are no wider than they need be.
    const BroomSector level = broom_sector({-0.1, 0.1}, shortest, longest);
    const BroomSector upright = broom_sector({1.5, 1.6}, shortest, longest);
    EXPECT_EQ(turn_sines(level, upright).high, 1);
    EXPECT_NEAR(turn_sines(level, upright).low, std::sin(1.4), 1e-12);
    EXPECT_EQ(turn_cosines(level, level).high, 1);
    EXPECT_NEAR(turn_cosines(level, level).low, std::cos(0.2), 1e-12);
}

}  // namespace
}  // namespace asv::core
