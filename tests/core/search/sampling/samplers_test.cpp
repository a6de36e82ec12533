#include "core/search/sampling/samplers.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include "core/search/prm.hpp"
#include "tests/kit/seeds.hpp"
#include "tests/kit/toy_spaces.hpp"

namespace asv::core {
namespace {

using test::PointSpace;
using test::Row;

std::vector<Row> draws(const SamplerOptions& options, PointSpace& space, std::size_t tries,
                       std::uint64_t seed = 1) {
    Sampler<PointSpace> sample = make_sampler<PointSpace>(options);
    Rng rng(seed);
    std::vector<Row> rows;
    Row row(2);
    for (std::size_t i = 0; i < tries; ++i)
        if (sample(space, rng, row)) rows.push_back(row);
    return rows;
}

SamplerOptions of(SamplerKind kind) {
    SamplerOptions options;
    options.kind = kind;
    options.sigma = 0.05;
    return options;
}

/// Share of the rows for which test(row) holds.
template <class Test>
double share(const std::vector<Row>& rows, Test&& test) {
    return static_cast<double>(std::count_if(rows.begin(), rows.end(), test)) /
           static_cast<double>(rows.size());
}

double to_wall(const Row& row) {
    return std::max({0.45 - row[0], row[0] - 0.55, 0.0});
}

TEST(Samplers, DrawOnlyValidConfigurationsAndRepeatThem) {
    PointSpace space(test::wall_with_door());
    for (const auto kind : {SamplerKind::own, SamplerKind::uniform, SamplerKind::grid,
                            SamplerKind::gaussian, SamplerKind::bridge, SamplerKind::passage}) {
        const auto rows = draws(of(kind), space, 3000);
        ASSERT_FALSE(rows.empty()) << static_cast<int>(kind);
        for (const Row& row : rows) ASSERT_TRUE(space.valid(row)) << static_cast<int>(kind);
        EXPECT_EQ(rows, draws(of(kind), space, 3000));
    }
}

TEST(Samplers, GridIsRegularAndGrowsFiner) {
    PointSpace space({});
    SamplerOptions options = of(SamplerKind::grid);
    options.grid_cells = 100;
    const auto first = draws(options, space, 100, 1);
    EXPECT_EQ(first, draws(options, space, 100, 2)) << "a grid knows no chance";
    std::set<double> x, y;
    for (const Row& row : first) {
        x.insert(row[0]);
        y.insert(row[1]);
    }
    EXPECT_EQ(x.size(), 10U);
    EXPECT_EQ(y.size(), 10U);
    EXPECT_EQ(std::set<Row>(first.begin(), first.end()).size(), 100U);
    const auto more = draws(options, space, 100 + 196);
    x.clear();
    for (std::size_t i = 100; i < more.size(); ++i) x.insert(more[i][0]);
    EXPECT_EQ(x.size(), 14U);
}

TEST(Samplers, GridDividesLongSidesMore) {
    test::for_seeds(100, [](Rng& rng) {
        std::vector<double> extents(1 + rng.below(5));
        for (double& extent : extents) extent = rng.uniform(0.1, 5);
        const std::size_t count = 1 + rng.below(5000);
        const auto divisions = grid_divisions(extents, count);
        std::size_t cells = 1;
        double longest = 0;
        for (std::size_t i = 0; i < extents.size(); ++i) {
            ASSERT_GE(divisions[i], 1U);
            cells *= divisions[i];
            longest = std::max(longest, extents[i] / static_cast<double>(divisions[i]));
        }
        ASSERT_LE(cells, count);
        // No side was divided while another one had longer cells.
        for (std::size_t i = 0; i < extents.size(); ++i) {
            if (divisions[i] > 1) {
                ASSERT_GE(extents[i] / static_cast<double>(divisions[i] - 1), longest - 1e-12);
            }
        }
    });
}

TEST(Samplers, GaussianIsNearObstacles) {
    PointSpace space(test::closed_wall());
    SamplerOptions options = of(SamplerKind::gaussian);
    options.sigma = 0.02;
    const auto rows = draws(options, space, 100000);
    ASSERT_GT(rows.size(), 500U);
    EXPECT_EQ(share(rows, [](const Row& row) { return to_wall(row) < 0.12; }), 1);
    EXPECT_GT(share(rows, [](const Row& row) { return to_wall(row) < 0.03; }), 0.7);
}

TEST(Samplers, BridgesStandInTheDoor) {
    PointSpace space(test::wall_with_door());
    const auto in_door = [](const Row& row) { return to_wall(row) == 0; };
    SamplerOptions options = of(SamplerKind::bridge);
    options.sigma = 0.05;
    const auto bridges = draws(options, space, 200000);
    ASSERT_GT(bridges.size(), 100U);
    const double uniform = share(draws(of(SamplerKind::uniform), space, 200000), in_door);
    EXPECT_GT(share(bridges, in_door), 20 * uniform);
}

TEST(Samplers, PassageIsWhereSomeButNotAllNeighboursCollide) {
    PointSpace space(test::closed_wall());
    SamplerOptions options = of(SamplerKind::passage);
    options.sigma = 0.01;
    const auto rows = draws(options, space, 100000);
    ASSERT_GT(rows.size(), 500U);
    // Near the wall or near the border of the square, which counts as one.
    const auto near = [](const Row& row) {
        return std::min({to_wall(row), row[0], row[1], 1 - row[0], 1 - row[1]}) < 0.05;
    };
    EXPECT_EQ(share(rows, near), 1);
    options.displacements = 0;
    EXPECT_EQ(draws(options, space, 1000), draws(of(SamplerKind::uniform), space, 1000));
}

TEST(Samplers, MixKeepsItsWeights) {
    // Two parts that can be told apart: the grid's first coordinates are few.
    PointSpace space({});
    SamplerOptions options = of(SamplerKind::mix);
    options.grid_cells = 1000000;
    options.weights[static_cast<std::size_t>(SamplerKind::grid)] = 3;
    options.weights[static_cast<std::size_t>(SamplerKind::uniform)] = 1;
    const auto rows = draws(options, space, 20000);
    Row whole(2);
    grid_point(std::vector<std::size_t>{1, 1}, 0, whole);
    const auto on_grid = [&](const Row& row) {
        const double cell = row[0] * 1000 - whole[0];
        return std::abs(cell - std::round(cell)) < 1e-9;
    };
    EXPECT_NEAR(share(rows, on_grid), 0.75, 0.02);
}

TEST(Samplers, AreRefusedWhereTheyCannotBe) {
    EXPECT_THROW(make_sampler<PointSpace>(of(SamplerKind::stepwise)), std::invalid_argument);
    EXPECT_THROW(make_sampler<PointSpace>(of(SamplerKind::corridor)), std::invalid_argument);
    EXPECT_THROW(make_sampler<PointSpace>(of(SamplerKind::mix)), std::invalid_argument);
}

TEST(Samplers, ServeAPlannerThroughTheSpace) {
    SampledBy<PointSpace> space(make_sampler<PointSpace>(of(SamplerKind::grid)),
                                test::wall_with_door());
    static_assert(SampledSpace<SampledBy<PointSpace>>);
    const Row start{0.1, 0.1}, goal{0.9, 0.1};
    PrmOptions options;
    options.samples = 100;
    Rng rng(1), other(2);
    const auto a = prm(space, {start, goal}, options, {}, rng);
    SampledBy<PointSpace> again(make_sampler<PointSpace>(of(SamplerKind::grid)),
                                test::wall_with_door());
    EXPECT_EQ(a.outcome, Outcome::solved);
    EXPECT_EQ(a.path, prm(again, {start, goal}, options, {}, other).path);
}

}  // namespace
}  // namespace asv::core
