#include "core/shorten/band/way_ties.hpp"

#include <cmath>
#include <vector>

#include "core/shorten/band/block_tridiagonal.hpp"
#include "tests/kit/chains/configurations.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using test::for_seeds;
using test::Points;
using test::Row;

/// A random chain in three configurations, and the ties of the middle one to its neighbours.
struct TiedChain {
    explicit TiedChain(Rng& rng)
        : asv_count(1 + rng.below(7)),
          chain(asv_count, 0.05, rng.chance(0.5) ? Anchor::centroid : Anchor::first_asv),
          rows(3, Row(chain.dimension())),
          poses(3, chain.make_pose()),
          force(chain.dimension()) {
        for (Row& row : rows)
            for (double& value : row) value = rng.uniform(-0.5, 0.5);
        for (std::size_t i = 0; i < 3; ++i) chain.forward(rows[i], poses[i]);
        WayTies(chain).tie(poses, 0, 0, system, force);
    }

    /// The positions with coordinate k of the middle configuration moved by a step.
    Points middle(std::size_t k, double step) const {
        Row change(chain.dimension(), 0.0);
        change[k] = step;
        return test::positions_of(chain, test::moved_by(chain, rows[1], change));
    }

    /// The way of all ASVs over such a middle.
    double length(std::size_t k, double step) const {
        const Points a = test::positions_of(chain, rows[0]), b = middle(k, step),
                     c = test::positions_of(chain, rows[2]);
        double sum = 0;
        for (std::size_t j = 0; j < asv_count; ++j)
            sum += std::hypot(b[j].x - a[j].x, b[j].y - a[j].y) +
                   std::hypot(c[j].x - b[j].x, c[j].y - b[j].y);
        return sum;
    }

    /// How fast each ASV moves with coordinate k.
    Points slopes(std::size_t k) const {
        const Points more = middle(k, 1e-6);
        Points slopes = middle(k, -1e-6);
        for (std::size_t j = 0; j < asv_count; ++j)
            slopes[j] = {(more[j].x - slopes[j].x) / 2e-6, (more[j].y - slopes[j].y) / 2e-6};
        return slopes;
    }

    /// A spring of the stiffness 1 / distance to either side, felt through two coordinates.
    double stiffness(const Points& one, const Points& other) const {
        double sum = 0;
        for (std::size_t j = 0; j < asv_count; ++j)
            for (const std::size_t side : {0U, 2U}) {
                const double distance =
                    std::hypot(poses[side].x[j] - poses[1].x[j], poses[side].y[j] - poses[1].y[j]);
                sum += (one[j].x * other[j].x + one[j].y * other[j].y) / distance;
            }
        return sum;
    }

    std::size_t asv_count;
    Chain chain;
    std::vector<Row> rows;
    std::vector<Pose> poses;
    BlockTridiagonal system;
    std::vector<double> force;
};

TEST(WayTies, PullLikeStringsAndAreAsStiffAsTheirDerivative) {
    for_seeds(30, [](Rng& rng) {
        TiedChain tied(rng);
        const std::size_t d = tied.chain.dimension();
        for (std::size_t k = 0; k < d; ++k) {
            constexpr double h = 1e-6;
            const double slope = (tied.length(k, h) - tied.length(k, -h)) / (2 * h);
            ASSERT_NEAR(tied.force[k], -slope, 1e-6);
        }
        std::vector<Points> slopes;
        for (std::size_t k = 0; k < d; ++k) slopes.push_back(tied.slopes(k));
        for (std::size_t r = 0; r < d; ++r)
            for (std::size_t c = 0; c < d; ++c) {
                const double expected = tied.stiffness(slopes[r], slopes[c]);
                ASSERT_NEAR(tied.system.diagonal(0)[c * d + r], expected, 1e-5 * (1 + expected));
            }
    });
}

}  // namespace
}  // namespace asv::core
