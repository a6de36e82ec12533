#include "core/generate/carve.hpp"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "core/search/rng.hpp"

namespace asv::core {
namespace {

using geometry::Box;
using geometry::grown;
using geometry::Point;

bool inside(const Box& box, const Point& point) {
    return point.x > box.low.x && point.x < box.high.x && point.y > box.low.y &&
           point.y < box.high.y;
}

bool in_any(const std::vector<Box>& boxes, const Point& point, double margin = 0) {
    return std::any_of(boxes.begin(), boxes.end(),
                       [&](const Box& box) { return inside(grown(box, margin), point); });
}

std::vector<Box> random_passages(std::size_t count, Rng& rng) {
    std::vector<Box> passages;
    for (std::size_t i = 0; i < count; ++i) {
        // Whole hundredths, so that many sides coincide.
        const auto pick = [&](std::size_t most) {
            return 0.01 * static_cast<double>(rng.below(most));
        };
        const Point low{pick(95) - 0.1, pick(95) - 0.1};
        passages.push_back({low, {low.x + 0.02 + pick(40), low.y + 0.02 + pick(20)}});
    }
    return passages;
}

TEST(Carve, LeavesExactlyWhatIsNotPassage) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        Rng rng(seed);
        const Box solid{{0, 0}, {1, 0.8}};
        const auto passages = random_passages(1 + rng.below(25), rng);
        const auto boxes = carve(solid, passages);
        for (int i = 0; i < 2000; ++i) {
            const Point point{rng.uniform(-0.2, 1.2), rng.uniform(-0.2, 1.2)};
            // Rounding moves sides by 5e-10; points that near decide nothing.
            if (in_any(passages, point, 1e-9) != in_any(passages, point, -1e-9)) continue;
            EXPECT_EQ(in_any(boxes, point), inside(solid, point) && !in_any(passages, point))
                << "seed " << seed << ": " << point.x << ' ' << point.y;
        }
    }
}

TEST(Carve, BoxesOverlapWhereverWallsMeet) {
    constexpr double shrink = -1e-5;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        Rng rng(seed);
        const Box solid{{0, 0}, {1, 1}};
        const auto passages = random_passages(1 + rng.below(12), rng);
        const auto boxes = carve(solid, passages);
        // All sides are at whole hundredths, so seams would be there.
        for (int x = 1; x < 100; ++x) {
            for (int y = 1; y < 100; ++y) {
                const Point point{0.01 * x, 0.01 * y};
                if (in_any(passages, point, 1e-4)) continue;
                EXPECT_TRUE(in_any(boxes, point, shrink))
                    << "seed " << seed << ": " << point.x << ' ' << point.y;
            }
        }
    }
}

TEST(Carve, NoBoxLiesInAnother) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        Rng rng(seed);
        const auto boxes = carve({{0, 0}, {1, 1}}, random_passages(15, rng));
        for (const Box& a : boxes) {
            for (const Box& b : boxes) {
                const bool contained = a.low.x >= b.low.x && a.low.y >= b.low.y &&
                                       a.high.x <= b.high.x && a.high.y <= b.high.y;
                EXPECT_TRUE(&a == &b || !contained) << "seed " << seed;
            }
        }
    }
}

TEST(Carve, WithoutPassagesTheSolidRemains) {
    const Box solid{{0.25, 0.5}, {0.75, 1}};
    EXPECT_EQ(carve(solid, {}), std::vector{solid});
    EXPECT_TRUE(carve(solid, std::vector{Box{{0, 0}, {1, 1}}}).empty());
}

}  // namespace
}  // namespace asv::core
