#include "core/shapes/flat_chain.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "core/generate/random_chain.hpp"
#include "geometry/predicates/polygon.hpp"

namespace asv::core {
namespace {

/// The least height of a strip, in any direction, that holds the closed polygon: one of the sides
/// of a convex polygon lies on the strip's border.
double min_width(const std::vector<Point>& polygon) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        if (length < 1e-9) continue;
        double low = 0, high = 0;
        for (const Point& p : polygon) {
            const double offset = ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / length;
            low = std::min(low, offset);
            high = std::max(high, offset);
        }
        least = std::min(least, high - low);
    }
    return least;
}

std::vector<Point> flat_chain(std::size_t n, double height) {
    std::vector<double> turns = flat_chain_turns(n, 0.05, height);
    for (double& turn : turns) turn = -turn;
    return chain_positions(turns, flat_chain_heading(n, 0.05, height), {0, 0}, 0.05);
}

TEST(MinFlatHeight, OfThreeAsvsIsThatOfAnIsoscelesTriangle) {
    // height * sqrt(length^2 - height^2) = area
    const double area = Requirements{}.min_area(3);
    const double square = 0.05 * 0.05;
    const double height = std::sqrt((square - std::sqrt(square * square - 4 * area * area)) / 2);
    EXPECT_NEAR(min_flat_height(3), height, 1e-15);
}

TEST(MinFlatHeight, OfManyAsvsIsThatOfAHalfStadium) {
    // Infinitely many brooms: two quarter circles and a straight line between them.
    const double n = 5000;
    const double length = 0.05 * (n - 1);
    const double area = Requirements{}.min_area(5000);
    using std::numbers::pi;
    const double height = (length - std::sqrt(length * length - 2 * pi * area)) / pi;
    EXPECT_NEAR(min_flat_height(5000) / height, 1, 1e-5);
}

TEST(FlatChain, FillsItsStripAndHasTheAreaThatTheFormulaSays) {
    for (const std::size_t n : {3u, 4u, 5u, 7u, 10u, 13u, 14u, 15u, 20u, 31u, 50u, 120u}) {
        for (const double factor : {1.0, 1.2, 1.7}) {
            const double height = factor * min_flat_height(n);
            if (height > 0.01 * static_cast<double>(n - 1)) continue;
            const auto chain = flat_chain(n, height);
            double low = 0, high = 0;
            for (const Point& point : chain) {
                low = std::min(low, point.y);
                high = std::max(high, point.y);
            }
            EXPECT_NEAR(low, 0, 1e-12) << n;
            EXPECT_NEAR(high, height, 1e-12) << n;
            EXPECT_NEAR(chain.back().y, 0, 1e-12) << n;
            EXPECT_NEAR(-geometry::signed_area(chain), flat_area(n - 1, 0.05, height), 1e-12) << n;
        }
        EXPECT_NEAR(flat_area(n - 1, 0.05, min_flat_height(n)), Requirements{}.min_area(n), 1e-12);
    }
}

TEST(FlatChain, HigherStripsHoldMoreArea) {
    for (const std::size_t brooms : {2u, 3u, 6u, 14u, 40u}) {
        double last = 0;
        for (int i = 1; i <= 200; ++i) {
            const double height = 0.01 * static_cast<double>(brooms) * i / 200;
            const double area = flat_area(brooms, 0.05, height);
            EXPECT_GT(area, last) << brooms << " brooms, height " << height;
            last = area;
        }
    }
}

TEST(MinFlatHeight, NoRandomShapeIsFlatter) {
    Rng rng(11);
    for (std::size_t n = 3; n <= 20; ++n) {
        ChainOptions options;
        options.asv_count = n;
        options.area_margin = 0;
        for (int i = 0; i < 300; ++i) {
            const auto chain = chain_positions(random_turns(options, {}, rng), 0, {0, 0}, 0.05);
            ASSERT_GE(min_width(chain), min_flat_height(n) - 1e-12) << n;
        }
    }
}

// A local search over the turns, with penalties for too little area and for a closing side that is
// not convex, comes down to the formula's height and never below it.
TEST(MinFlatHeight, SearchComesDownToItAndNeverBelow) {
    Rng rng(12);
    for (const std::size_t n : {4u, 5u, 6u, 7u}) {
        const double wanted = Requirements{}.min_area(n);
        const auto cost = [&](const std::vector<double>& turns) {
            const auto chain = chain_positions(turns, 0, {0, 0}, 0.05);
            const double lacking = std::max(0.0, wanted - geometry::signed_area(chain));
            const bool convex = geometry::convex_orientation(chain) == 1;
            return min_width(chain) + 200 * lacking + (convex ? 0 : 1);
        };
        ChainOptions options;
        options.asv_count = n;
        double best = 1;
        for (int restart = 0; restart < 12; ++restart) {
            std::vector<double> turns = random_turns(options, {}, rng);
            double least = cost(turns);
            double step = 0.3;
            for (int i = 0; i < 12'000; ++i) {
                std::vector<double> tried = turns;
                if (rng.chance(0.5)) {
                    tried[rng.below(tried.size())] += step * rng.normal();
                } else {
                    for (double& turn : tried) turn += step * rng.normal();
                }
                for (double& turn : tried) turn = std::max(0.0, turn);
                if (const double value = cost(tried); value < least) {
                    least = value;
                    turns = tried;
                }
                if (i % 1000 == 999) step *= 0.5;
            }
            best = std::min(best, least);
        }
        EXPECT_GE(best, min_flat_height(n) - 1e-6) << n;
        EXPECT_LE(best, 1.01 * min_flat_height(n)) << n;
    }
}

TEST(FlatChain, RejectsWhatCannotLieFlat) {
    EXPECT_THROW(flat_area(1, 0.05, 0.01), std::invalid_argument);
    EXPECT_THROW(flat_area(6, 0.05, 0), std::invalid_argument);
    EXPECT_THROW(flat_area(6, 0.05, 0.2), std::invalid_argument);
    EXPECT_THROW(flat_area(6, 0, 0.01), std::invalid_argument);
    EXPECT_THROW(min_flat_height(2), std::invalid_argument);
    Requirements greedy;
    greedy.area_radius_per_broom = 0.02;
    EXPECT_THROW(min_flat_height(7, greedy), std::invalid_argument);
    EXPECT_THROW(round_diameter(2), std::invalid_argument);
}

TEST(RoundChain, HasMoreThanTheLeastArea) {
    for (std::size_t n = 3; n <= 200; ++n) {
        const double angle = 2 * std::acos(-1.0) / static_cast<double>(n);
        const auto chain = chain_positions(std::vector<double>(n - 2, angle), 0, {0, 0}, 0.05);
        EXPECT_GT(geometry::signed_area(chain), 1.2 * Requirements{}.min_area(n));
        double farthest = 0;
        for (const Point& a : chain) {
            for (const Point& b : chain)
                farthest = std::max(farthest, std::hypot(a.x - b.x, a.y - b.y));
        }
        EXPECT_LE(farthest, round_diameter(n) + 1e-12);
    }
}

}  // namespace
}  // namespace asv::core
