#include "core/bounds/corridors/area_between_walls.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "core/shapes/flat_chain.hpp"
#include "geometry/predicates/polygon.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using test::for_seeds;
using test::scaled;

/// Any chain in the strip from 0 to `height`: joints at random heights, among them many at a wall;
/// brooms mostly forwards.
std::vector<geometry::Point> chain_between_walls(std::size_t asv_count, double broom, double height,
                                                 Rng& rng) {
    std::vector<geometry::Point> chain;
    const double at_a_wall = rng.uniform(0, 1), forwards = rng.uniform(0.7, 1);
    double x = 0;
    while (chain.size() < asv_count) {
        double y = rng.uniform(0, height);
        if (rng.chance(at_a_wall)) y = rng.chance(0.7) ? height : 0;
        if (!chain.empty()) {
            const double climb = y - chain.back().y;
            if (std::abs(climb) > broom) continue;
            x += (rng.chance(forwards) ? 1 : -1) * std::sqrt(broom * broom - climb * climb);
        }
        chain.push_back({x, y});
    }
    return chain;
}

TEST(AreaBetweenWalls, NoChainEnclosesMore) {
    double nearest = 0;
    for_seeds(scaled(20), [&](Rng& rng) {
        const std::size_t n = 3 + rng.below(8);
        const double height = std::exp(rng.uniform(std::log(0.001), std::log(0.2)));
        const double most = max_area_between_walls(n, 0.05, height);
        for (int i = 0; i < 20'000; ++i) {
            const auto chain = chain_between_walls(n, 0.05, height, rng);
            const double area = std::abs(geometry::signed_area(chain));
            ASSERT_LE(area, most) << n << " ASVs, " << height << " high";
            nearest = std::max(nearest, area / most);
        }
    });
    EXPECT_GT(nearest, 0.9) << "chains that enclose little say nothing";
}

TEST(AreaBetweenWalls, IsHardlyMoreThanThatOfTheFlattestChain) {
    for (const std::size_t n : {3u, 4u, 7u, 12u, 30u}) {
        for (const double share : {0.2, 0.6, 1.0}) {
            const double height = share * min_flat_height(n);
            const double flat = flat_area(n - 1, 0.05, height);
            const double most = max_area_between_walls(n, 0.05, height);
            EXPECT_GE(most, flat) << n << " ASVs";
            EXPECT_LE(most, 1.005 * flat) << n << " ASVs, share " << share;
        }
    }
}

TEST(AreaBetweenWalls, HeightWithoutChainsIsHardlyBelowThatOfTheFlattestOne) {
    Requirements as_lenient_as_the_validator;
    as_lenient_as_the_validator.broom_length += 1e-5;
    for (const std::size_t n : {3u, 4u, 7u, 12u, 30u}) {
        Requirements& r = as_lenient_as_the_validator;
        const Requirements classic;
        const auto brooms = static_cast<double>(n - 1);
        const double area = classic.min_area(n) - classic.tolerance;
        r.area_radius_per_broom = std::sqrt(area / std::numbers::pi) / brooms;
        const double flattest = min_flat_height(n, r);
        const double without = height_without_chains(n, classic);
        EXPECT_LT(without, flattest) << n << " ASVs";
        EXPECT_GT(without, 0.997 * flattest) << n << " ASVs";
        std::cout << n << " ASVs: closed up to "
                  << (without - 2 * classic.tolerance) / min_flat_height(n)
                  << " of the height that a flat chain needs\n";
    }
    EXPECT_EQ(height_without_chains(2, {}), 0);
    Requirements without_area;
    without_area.area_radius_per_broom = 0;
    EXPECT_EQ(height_without_chains(7, without_area), 0);
}

}  // namespace
}  // namespace asv::core
