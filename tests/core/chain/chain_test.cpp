#include "core/chain/chain.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "core/model/problem.hpp"
#include "tests/kit/chains/configurations.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using test::for_seeds;
using test::Points;
using test::Row;

constexpr std::size_t sizes[] = {1, 2, 3, 7, 25, 50};
constexpr double pi = std::numbers::pi;

struct ChainOf : ::testing::TestWithParam<std::tuple<std::size_t, Anchor>> {
    std::size_t n = std::get<0>(GetParam());
    Chain chain{n, 0.05, std::get<1>(GetParam())};

    Row random_row(Rng& rng) const {
        Row row(chain.dimension());
        for (std::size_t i = 0; i < row.size(); ++i)
            row[i] = i < 2 ? rng.uniform() : rng.uniform(-pi, pi);
        return row;
    }
};

/// The pose's points.
Points forward(const Chain& chain, const Row& row) {
    Pose pose = chain.make_pose();
    chain.forward(row, pose);
    Points points(chain.asv_count());
    copy_positions(pose, points);
    return points;
}

void expect_near(const Points& found, const Points& expected, double tolerance) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        ASSERT_LE(std::hypot(found[i].x - expected[i].x, found[i].y - expected[i].y), tolerance)
            << "ASV " << i + 1;
}

TEST_P(ChainOf, ForwardIsTheTextbook) {
    for_seeds(50, [&](Rng& rng) {
        const Row row = random_row(rng);
        expect_near(forward(chain, row), test::positions_of(chain, row), 1e-14);
    });
}

TEST_P(ChainOf, RoundTripKeepsThePositions) {
    for_seeds(50, [&](Rng& rng) {
        const Points points = test::positions_of(chain, random_row(rng));
        expect_near(forward(chain, test::row_of(chain, points)), points, 1e-13);
    });
}

TEST_P(ChainOf, RoundTripKeepsTheRowUpToFullTurns) {
    for_seeds(50, [&](Rng& rng) {
        const Row row = random_row(rng);
        const Row back = test::row_of(chain, forward(chain, row));
        ASSERT_EQ(back.size(), chain.dimension());
        for (std::size_t i = 0; i < row.size(); ++i) {
            const double full = i == 2 ? 2 * pi : 0;
            const double off =
                full == 0 ? back[i] - row[i] : std::remainder(back[i] - row[i], full);
            ASSERT_NEAR(off, 0, 1e-12) << "coordinate " << i;
        }
    });
}

TEST_P(ChainOf, RoundingOfAFileSpreadsOverTheChain) {
    for_seeds(50, [&](Rng& rng) {
        Points points = test::positions_of(chain, random_row(rng));
        for (Point& p : points) p = {std::round(p.x * 1e6) / 1e6, std::round(p.y * 1e6) / 1e6};
        // Each broom is off by less than the diagonal of a grid cell.
        const double most = 1.5e-6 * static_cast<double>(chain.broom_count()) + 1e-15;
        expect_near(forward(chain, test::row_of(chain, points)), points, most);
    });
}

TEST_P(ChainOf, HeadingRatesAreThoseOfTheForwardKinematics) {
    if (n < 2) return;
    for_seeds(10, [&](Rng& rng) {
        const Row from = random_row(rng), to = random_row(rng);
        Row displacement(to), rates(chain.broom_count());
        for (std::size_t i = 0; i < to.size(); ++i) displacement[i] -= from[i];
        chain.headings(displacement, rates);
        Pose first = chain.make_pose(), last = chain.make_pose();
        chain.forward(from, first);
        chain.forward(to, last);
        for (std::size_t k = 0; k < rates.size(); ++k)
            ASSERT_NEAR(rates[k], last.heading[k] - first.heading[k], 1e-12);
    });
}

TEST_P(ChainOf, LeversAreDerivatives) {
    if (n < 2) return;
    constexpr double h = 1e-6;
    for_seeds(3, [&](Rng& rng) {
        const Row row = random_row(rng);
        Pose pose = chain.make_pose();
        chain.forward(row, pose);
        const std::size_t j = rng.below(chain.broom_count());
        const double s = rng.uniform();
        const auto point = [&](const Row& at) {
            const Points p = test::positions_of(chain, at);
            return Point{p[j].x + s * (p[j + 1].x - p[j].x), p[j].y + s * (p[j + 1].y - p[j].y)};
        };
        for (std::size_t i = 2; i < row.size(); ++i) {
            Row unit(row.size(), 0.0), rates(chain.broom_count()), above(row), below(row);
            unit[i] = 1;
            chain.headings(unit, rates);
            double dx = 0, dy = 0;
            for (std::size_t k = 0; k < rates.size(); ++k) {
                dx -= 0.05 * chain.lever(j, s, k) * rates[k] * pose.uy[k];
                dy += 0.05 * chain.lever(j, s, k) * rates[k] * pose.ux[k];
            }
            above[i] += h;
            below[i] -= h;
            const Point a = point(above), b = point(below);
            ASSERT_NEAR(dx, (a.x - b.x) / (2 * h), 1e-8) << "coordinate " << i;
            ASSERT_NEAR(dy, (a.y - b.y) / (2 * h), 1e-8) << "coordinate " << i;
        }
    });
}

TEST_P(ChainOf, HeadingShareOffsetsTheFirstHeading) {
    if (n < 2) return;
    Rng rng(1);
    const Row row = random_row(rng);
    Pose pose = chain.make_pose();
    chain.forward(row, pose);
    double heading = row[2];
    ASSERT_EQ(chain.heading_share().size(), chain.turn_count());
    for (std::size_t i = 0; i < chain.turn_count(); ++i)
        heading -= chain.heading_share()[i] * row[3 + i];
    EXPECT_NEAR(pose.heading[0], heading, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Sizes, ChainOf,
                         ::testing::Combine(::testing::ValuesIn(sizes),
                                            ::testing::Values(Anchor::first_asv, Anchor::centroid)),
                         [](const auto& given) {
                             return std::to_string(std::get<0>(given.param)) +
                                    (std::get<1>(given.param) == Anchor::centroid ? "ByCentroid"
                                                                                  : "ByFirst");
                         });

TEST(Chain, StraightJointsHaveNoTurn) {
    const Chain chain(4, 0.05, Anchor::first_asv);
    const Row row = test::row_of(chain, {{0, 0}, {0.05, 0}, {0.1, 0}, {0.1, 0.05}});
    EXPECT_EQ(row, (Row{0, 0, 0, 0, pi / 2}));
}

TEST(Chain, RefusesWhatIsNoChain) {
    EXPECT_THROW(Chain(0, 0.05, Anchor::first_asv), std::invalid_argument);
    EXPECT_THROW(Chain(3, 0, Anchor::first_asv), std::invalid_argument);
}

}  // namespace
}  // namespace asv::core
