#include "asv/core/planning/nearest.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "support.hpp"

namespace asv::core {
namespace {

using testing::Row;

struct Scan {
    Row scales;
    std::optional<std::size_t> wrapping;

    double distance(std::span<const double> a, std::span<const double> b) const {
        double sum = 0;
        for (std::size_t i = 0; i < scales.size(); ++i) {
            double off = a[i] - b[i];
            if (i == wrapping) off = std::remainder(off, 2 * std::numbers::pi);
            sum += off * off * scales[i] * scales[i];
        }
        return std::sqrt(sum);
    }
};

/// The index may be a little wrong, as it counts in single precision.
void expect_nearest(Rng& rng, std::size_t dimension, std::optional<std::size_t> wrapping,
                    std::size_t count) {
    Scan scan{Row(dimension), wrapping};
    for (double& scale : scan.scales) scale = rng.uniform(0.1, 1);
    NearestNeighbours index(scan.scales, wrapping);
    std::vector<Row> rows;
    const auto draw = [&] {
        Row row(dimension);
        for (std::size_t i = 0; i < dimension; ++i)
            row[i] = i == wrapping ? rng.uniform(-20, 20) : rng.uniform(-1, 1);
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
    testing::for_seeds(10, [](Rng& rng) {
        for (const std::size_t dimension : {1U, 2U, 3U, 8U, 16U, 26U})
            expect_nearest(rng, dimension, std::nullopt, 150);
    });
}

TEST(NearestNeighbours, AgreeWithBruteForceWhereAnAngleWraps) {
    testing::for_seeds(10, [](Rng& rng) {
        for (const std::size_t dimension : {3U, 4U, 8U, 26U})
            expect_nearest(rng, dimension, 2, 150);
    });
}

TEST(NearestNeighbours, FirstOfEqualRows) {
    const Row scales{1, 1};
    NearestNeighbours index(scales, std::nullopt);
    for (int i = 0; i < 40; ++i) index.add(Row{1, 1});
    EXPECT_EQ(index.nearest(Row{0, 0}), 0U);
}

}  // namespace
}  // namespace asv::core
