#include "core/search/trees/nearest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "tests/kit/chains/configurations.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using test::Row;

struct Scan {
    Row scales;
    WrappingAngles wrapping;

    double distance(std::span<const double> a, std::span<const double> b) const {
        double sum = 0;
        for (std::size_t i = 0; i < scales.size(); ++i) {
            double off = a[i] - b[i];
            if (wrapping.contains(i)) off = std::remainder(off, 2 * std::numbers::pi);
            sum += off * off * scales[i] * scales[i];
        }
        return std::sqrt(sum);
    }
};

/// The index may be a little wrong, as it counts in single precision.
void expect_nearest(Rng& rng, std::size_t dimension, WrappingAngles wrapping, std::size_t count) {
    Scan scan{Row(dimension), wrapping};
    for (double& scale : scan.scales) scale = rng.uniform(0.1, 1);
    NearestNeighbours index(scan.scales, wrapping);
    std::vector<Row> rows;
    const auto draw = [&] {
        Row row(dimension);
        for (std::size_t i = 0; i < dimension; ++i)
            row[i] = wrapping.contains(i) ? rng.uniform(-20, 20) : rng.uniform(-1, 1);
        return row;
    };
    while (rows.size() < count) {
        rows.push_back(draw());
        index.add(rows.back());
        ASSERT_EQ(index.size(), rows.size());
        const Row query = draw();
        double least = std::numeric_limits<double>::infinity();
        for (const Row& row : rows) least = std::min(least, scan.distance(row, query));
        ASSERT_LE(scan.distance(rows[index.nearest(query)], query), least + 1e-5);
    }
}

TEST(NearestNeighbours, AgreeWithBruteForce) {
    test::for_seeds(10, [](Rng& rng) {
        for (const std::size_t dimension : {1U, 2U, 3U, 8U, 16U, 26U})
            expect_nearest(rng, dimension, WrappingAngles{}, 150);
    });
}

TEST(NearestNeighbours, AgreeWithBruteForceAmongMany) {
    test::for_seeds(2, [](Rng& rng) { expect_nearest(rng, 5, {2, 1}, 1500); });
}

TEST(NearestNeighbours, AgreeWithBruteForceWhereAnAngleWraps) {
    test::for_seeds(10, [](Rng& rng) {
        for (const std::size_t dimension : {3U, 4U, 8U, 26U})
            expect_nearest(rng, dimension, {2, dimension > 4 ? 3U : 1U}, 150);
    });
}

/// The rows sorted by the distance that the scan finds, which the queries for many have to agree
/// with up to single precision.
TEST(NearestNeighbours, ManyAndWithinAgreeWithBruteForce) {
    test::for_seeds(50, [](Rng& rng) {
        const std::size_t dimension = 3 + rng.below(5), size = 1 + rng.below(1500);
        Scan scan{Row(dimension), {1, rng.below(3)}};
        for (double& scale : scan.scales) scale = rng.uniform(0.1, 1);
        NearestNeighbours index(scan.scales, scan.wrapping);
        std::vector<Row> rows(size, Row(dimension));
        Row query(dimension);
        for (double& x : query) x = rng.uniform(-9, 9);
        std::vector<double> distances;
        for (Row& row : rows) {
            for (double& x : row) x = rng.uniform(-9, 9);
            index.add(row);
            distances.push_back(scan.distance(row, query));
        }
        std::vector<double> sorted = distances;
        std::sort(sorted.begin(), sorted.end());

        const std::size_t count = rng.below(size + 5);
        const auto nearest = index.nearest(query, count);
        ASSERT_EQ(nearest.size(), std::min(count, size));
        for (std::size_t i = 0; i < nearest.size(); ++i)
            ASSERT_NEAR(distances[nearest[i]], sorted[i], 1e-4);

        const double radius = rng.uniform(0, sorted.back());
        const auto within = index.within(query, radius);
        for (std::size_t i = 0; i < within.size(); ++i)
            ASSERT_NEAR(distances[within[i]], sorted[i], 1e-4);
        for (std::size_t i = 0; i < size; ++i) {
            if (std::abs(distances[i] - radius) < 1e-4) continue;
            ASSERT_EQ(std::count(within.begin(), within.end(), i), distances[i] < radius ? 1 : 0);
        }
    });
}

TEST(NearestNeighbours, FactorsScaleAndHide) {
    const Row scales{1};
    NearestNeighbours index(scales, {});
    for (const double x : {1.0, 2.0, 4.0}) index.add(Row{x});
    constexpr float hidden = std::numeric_limits<float>::infinity();
    const auto nearest = [&](std::vector<float> factors) { return index.nearest(Row{0}, factors); };
    EXPECT_EQ(nearest({1, 1, 1}), 0U);
    EXPECT_EQ(nearest({1, 0.4f, 1}), 1U);
    EXPECT_EQ(nearest({hidden, 1, 0.4f}), 2U);
    EXPECT_EQ(nearest({hidden, hidden, hidden}), std::nullopt);
    EXPECT_EQ(index.nearest(Row{1}, std::vector<float>{hidden, 1, 1}), 1U);
}

TEST(NearestNeighbours, AnAngleOfNoWeightDoesNotCount) {
    const Row scales{1, 0};
    NearestNeighbours index(scales, {1, 1});
    index.add(Row{5, 0});
    index.add(Row{1, 3});
    EXPECT_EQ(index.nearest(Row{0, 0}), 1U);
}

TEST(NearestNeighbours, FirstOfEqualRows) {
    const Row scales{1, 1};
    NearestNeighbours index(scales, {});
    for (int i = 0; i < 40; ++i) index.add(Row{1, 1});
    EXPECT_EQ(index.nearest(Row{0, 0}), 0U);
}

}  // namespace
}  // namespace asv::core
