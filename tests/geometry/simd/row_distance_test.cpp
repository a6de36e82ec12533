#include "geometry/simd/row_distance.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/kit/geometry/adversary.hpp"
#include "tests/kit/geometry/forced_target.hpp"

namespace asv::geometry {
namespace {

using geometry::simd::block_rows;
using test::Adversary;
using test::ForcedTarget;

TEST(RowDistance, TheStatedOperationsWithTheSameBitsOnEveryTarget) {
    Adversary draw(5);
    for (const std::size_t dimension : {1UL, 2UL, 5UL, 17UL}) {
        for (const std::size_t blocks : {1UL, 2UL, 7UL}) {
            const auto some = [&](std::size_t count, double reach) {
                std::vector<float> values(count);
                for (float& value : values) value = static_cast<float>(draw.uniform(-reach, reach));
                return values;
            };
            const auto rows = some(blocks * block_rows * dimension, 20), from = some(dimension, 20);
            std::vector<float> period(dimension, 0.F), inverse(dimension, 0.F);
            for (std::size_t i = 0; i < dimension; i += 3) {
                period[i] = static_cast<float>(draw.uniform(0.5, 7));
                inverse[i] = 1 / period[i];
            }
            std::vector<float> expected, expected_least;
            for (std::size_t row = 0; row < blocks * block_rows; ++row) {
                float sum = 0;
                for (std::size_t i = 0; i < dimension; ++i) {
                    const std::size_t block = row / block_rows * dimension + i;
                    float difference = rows[block * block_rows + row % block_rows] - from[i];
                    difference -= period[i] * std::nearbyint(difference * inverse[i]);
                    sum += difference * difference;
                }
                expected.push_back(sum);
                if (row % block_rows == 0) expected_least.push_back(sum);
                expected_least.back() = std::min(expected_least.back(), sum);
            }
            for (const std::string& target : geometry::simd::instruction_sets()) {
                const ForcedTarget forced(target);
                std::vector<float> squared(expected.size()), least(blocks);
                geometry::simd::squared_distances(rows, {from, period, inverse}, squared, least);
                EXPECT_EQ(squared, expected) << target;
                EXPECT_EQ(least, expected_least) << target;
            }
        }
    }
}

}  // namespace
}  // namespace asv::geometry
