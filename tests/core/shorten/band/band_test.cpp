#include <cmath>

#include "core/search/trees/two_trees.hpp"
#include "core/shorten/band/block_tridiagonal.hpp"
#include "core/shorten/band/elastic_band.hpp"
#include "core/shorten/band/way_ties.hpp"
#include "core/space/sampling/shape_sampler.hpp"
#include "core/space/steering/near_constraints.hpp"
#include "core/space/steering/slide.hpp"
#include "tests/kit/oracle.hpp"

namespace asv::core {
namespace {

using testing::for_seeds;
using testing::nth;
using testing::Oracle;
using testing::Points;
using testing::ring;
using testing::Row;
using testing::scaled;

bool never() {
    return false;
}

/// Heading coordinates [x, y, headings] moved by a step, as a row.
Row moved_by(const Chain& chain, std::span<const double> row, std::span<const double> step) {
    Row out(row.begin(), row.end());
    for (std::size_t k = 0; k < std::min<std::size_t>(out.size(), 3); ++k) out[k] += step[k];
    for (std::size_t t = 0; t < chain.turn_count(); ++t) {
        const double turn = step[3 + t] - step[2 + t];
        out[2] += chain.heading_share()[t] * turn;
        out[3 + t] += turn;
    }
    return out;
}

TEST(BlockTridiagonal, SolvesWhatMultiplyingMade) {
    for_seeds(50, [](Rng& rng) {
        const std::size_t blocks = 1 + rng.below(6), size = 1 + rng.below(9), all = blocks * size;
        // A' A with A block bidiagonal is block tridiagonal and positive definite.
        std::vector<double> a(all * all, 0.0), matrix(all * all, 0.0);
        for (std::size_t r = 0; r < all; ++r)
            for (std::size_t c = 0; c < all; ++c) {
                const std::size_t row = r / size, column = c / size;
                if (row == column || row + 1 == column) a[r * all + c] = rng.uniform(-1, 1);
                if (r == c) a[r * all + c] += 3;
            }
        for (std::size_t r = 0; r < all; ++r)
            for (std::size_t c = 0; c < all; ++c)
                for (std::size_t k = 0; k < all; ++k)
                    matrix[r * all + c] += a[k * all + r] * a[k * all + c];
        BlockTridiagonal system;
        system.reset(blocks, size);
        for (std::size_t b = 0; b < blocks; ++b)
            for (std::size_t r = 0; r < size; ++r)
                for (std::size_t c = 0; c < size; ++c) {
                    const std::size_t at = (b * size + r) * all + b * size + c;
                    system.diagonal(b)[c * size + r] = matrix[at];
                    if (b + 1 < blocks) system.upper(b)[c * size + r] = matrix[at + size];
                }
        std::vector<double> expected(all), vector(all, 0.0);
        for (double& value : expected) value = rng.uniform(-1, 1);
        for (std::size_t r = 0; r < all; ++r)
            for (std::size_t c = 0; c < all; ++c) vector[r] += matrix[r * all + c] * expected[c];
        ASSERT_TRUE(system.solve(vector));
        for (std::size_t i = 0; i < all; ++i) ASSERT_NEAR(vector[i], expected[i], 1e-9);
    });
}

TEST(BlockTridiagonal, SaysWhatIsNotPositiveDefinite) {
    BlockTridiagonal system;
    system.reset(2, 1);
    system.diagonal(0)[0] = 1;
    system.upper(0)[0] = 2;
    system.diagonal(1)[0] = 1;
    std::vector<double> vector{1, 1};
    EXPECT_FALSE(system.solve(vector));
}

TEST(NearConstraints, GradientsAreThoseOfTheGaps) {
    std::size_t kinds[7] = {};
    for_seeds(scaled(60), [&](Rng& rng) {
        const std::size_t n = 1 + rng.below(9);
        Problem problem = testing::problem(ring(n == 2 ? 3 : n, {0.3, 0.3}, 1),
                                           ring(n == 2 ? 3 : n, {0.7, 0.7}, 2));
        problem.obstacles = testing::clutter(rng, 25, 0.08, problem);
        const Anchor anchor = rng.chance(0.5) ? Anchor::centroid : Anchor::first_asv;
        const ChainWorld world(problem, anchor);
        MotionChecker checker = world.make_checker();
        ShapeSampler sampler(checker);
        Row row(world.chain.dimension());
        if (!sampler.sample(rng, row)) return;
        NearConstraints near(world.chain, world.constraints, world.field);
        Pose pose = world.chain.make_pose();
        world.chain.forward(row, pose);
        const auto found = near.find(pose, 0.05);
        const std::vector<NearConstraint> list(found.begin(), found.end());
        Row gradient(row.size());
        for (const NearConstraint& one : list) {
            // Beyond its end, the line of a broom turns by more than the end moves.
            if (one.kind == NearConstraint::Kind::corner) {
                const std::size_t b = one.index;
                const double along =
                    (one.nx - pose.x[b]) * pose.ux[b] + (one.ny - pose.y[b]) * pose.uy[b];
                if (along < 0 || along > world.chain.broom_length()) continue;
            }
            ++kinds[static_cast<std::size_t>(one.kind)];
            near.gradient(one, pose, gradient);
            for (std::size_t k = 0; k < row.size(); ++k) {
                constexpr double h = 1e-6;
                Row step(row.size(), 0.0);
                double gap[2];
                for (const int side : {0, 1}) {
                    step[k] = side == 0 ? -h : h;
                    const Row there = moved_by(world.chain, row, step);
                    Pose moved = world.chain.make_pose();
                    world.chain.forward(there, moved);
                    gap[side] = near.gap(one, there, moved);
                }
                ASSERT_NEAR(gradient[k], (gap[1] - gap[0]) / (2 * h), 1e-6);
            }
        }
    });
    for (const std::size_t kind : kinds) EXPECT_GT(kind, 0U);
}

TEST(WayTies, PullLikeStringsAndAreAsStiffAsTheirDerivative) {
    for_seeds(30, [](Rng& rng) {
        const std::size_t n = 1 + rng.below(7), d = n + 1;
        const Chain chain(n, 0.05, rng.chance(0.5) ? Anchor::centroid : Anchor::first_asv);
        std::vector<Row> rows(3, Row(d));
        for (Row& row : rows)
            for (double& value : row) value = rng.uniform(-0.5, 0.5);
        std::vector<Pose> poses(3, chain.make_pose());
        for (std::size_t i = 0; i < 3; ++i) chain.forward(rows[i], poses[i]);
        WayTies ties(chain);
        BlockTridiagonal system;
        std::vector<double> force(d);
        ties.tie(poses, 0, 0, system, force);
        const auto length = [&](std::span<const double> middle) {
            const Points a = testing::positions_of(chain, rows[0]),
                         b = testing::positions_of(chain, middle),
                         c = testing::positions_of(chain, rows[2]);
            double sum = 0;
            for (std::size_t j = 0; j < n; ++j)
                sum += std::hypot(b[j].x - a[j].x, b[j].y - a[j].y) +
                       std::hypot(c[j].x - b[j].x, c[j].y - b[j].y);
            return sum;
        };
        for (std::size_t k = 0; k < d; ++k) {
            constexpr double h = 1e-6;
            Row step(d, 0.0);
            step[k] = h;
            const double more = length(moved_by(chain, rows[1], step));
            step[k] = -h;
            const double less = length(moved_by(chain, rows[1], step));
            ASSERT_NEAR(force[k], -(more - less) / (2 * h), 1e-6);
        }
        // A spring of the stiffness 1 / distance to either side, felt through each coordinate.
        std::vector<Points> slopes;
        for (std::size_t k = 0; k < d; ++k) {
            Row step(d, 0.0);
            step[k] = 1e-6;
            const Points more = testing::positions_of(chain, moved_by(chain, rows[1], step));
            step[k] = -1e-6;
            slopes.push_back(testing::positions_of(chain, moved_by(chain, rows[1], step)));
            for (std::size_t j = 0; j < n; ++j)
                slopes[k][j] = {(more[j].x - slopes[k][j].x) / 2e-6,
                                (more[j].y - slopes[k][j].y) / 2e-6};
        }
        for (std::size_t r = 0; r < d; ++r)
            for (std::size_t c = 0; c < d; ++c) {
                double expected = 0;
                for (std::size_t j = 0; j < n; ++j)
                    for (const std::size_t other : {0U, 2U}) {
                        const double distance = std::hypot(poses[other].x[j] - poses[1].x[j],
                                                           poses[other].y[j] - poses[1].y[j]);
                        expected +=
                            (slopes[r][j].x * slopes[c][j].x + slopes[r][j].y * slopes[c][j].y) /
                            distance;
                    }
                ASSERT_NEAR(system.diagonal(0)[c * d + r], expected, 1e-5 * (1 + expected));
            }
    });
}

/// A path by slides among boxes.
struct SlidPath {
    SlidPath(Rng& rng, std::size_t n)
        : world(cluttered(rng, n), Anchor::centroid),
          checker(world.make_checker()),
          rows(world.start) {
        SlideSteering steering(checker, world.metric, {});
        testing::wander(checker, steering, rng, 3, rows);
    }
    static Problem cluttered(Rng& rng, std::size_t n) {
        Problem problem = testing::problem(ring(n, {0.2, 0.2}, 1), ring(n, {0.8, 0.8}, 2));
        problem.obstacles = testing::clutter(rng, 25, 0.1, problem);
        return problem;
    }
    ChainWorld world;
    MotionChecker checker;
    Configurations rows;
};

TEST(ElasticBand, GainsAndKeepsEndsAndValidity) {
    double before = 0, after = 0;
    for_seeds(scaled(30), [&](Rng& rng) {
        const std::size_t sizes[] = {1, 3, 5, 7, 15};
        SlidPath made(rng, sizes[rng.below(5)]);
        const std::size_t d = made.world.chain.dimension();
        MotionCost cost(made.world.chain);
        ElasticBand band(made.checker, made.world.metric);
        band.take(made.rows, 0.04);
        double now = cost.path(made.rows);
        before += now;
        for (int i = 0; i < 4; ++i) {
            const double gained = band.tighten(never);
            ASSERT_GE(gained, 0);
            const Configurations path = band.path();
            Oracle(made.world).expect_valid_path(path, 20);
            ASSERT_LE(cost.path(path), (now - gained) * (1 + 1e-6));
            now = cost.path(path);
            for (std::size_t k = 0; k < d; ++k) {
                ASSERT_EQ(path[k], made.rows[k]);
                ASSERT_EQ(path[path.size() - d + k], made.rows[made.rows.size() - d + k]);
            }
        }
        after += now;
    });
    EXPECT_LT(after, 0.8 * before);
}

TEST(ElasticBand, WithoutObstaclesAllGoStraight) {
    for_seeds(scaled(10), [](Rng& rng) {
        const Points start = ring(7, {0.25, 0.3}, 1);
        Points goal = testing::moved(start, 0.5, 0.3);
        const ChainWorld world(testing::problem(start, goal), Anchor::centroid);
        MotionChecker checker = world.make_checker();
        SlideSteering steering(checker, world.metric, {});
        Row aside(world.start);
        aside[0] = rng.uniform(0.3, 0.7);
        aside[1] = rng.uniform(0.3, 0.7);
        Configurations rows(world.start);
        ASSERT_EQ(steering.slide(world.start, aside, rows), Steered::reached);
        ASSERT_EQ(steering.slide(aside, world.goal, rows), Steered::reached);
        ElasticBand band(checker, world.metric);
        band.take(rows, 0.05);
        for (int i = 0; i < 20; ++i) band.tighten(never);
        EXPECT_NEAR(MotionCost(world.chain).path(band.path()), 7 * std::hypot(0.5, 0.3), 1e-3);
    });
}

TEST(ElasticBand, StopsWhenToldAndLeavesThePath) {
    Rng rng(3);
    SlidPath made(rng, 7);
    ElasticBand band(made.checker, made.world.metric);
    band.take(made.rows, 0.05);
    const Configurations untouched = band.path();
    band.take(made.rows, 0.05);
    EXPECT_EQ(band.tighten([] { return true; }), 0);
    EXPECT_EQ(band.path(), untouched);
}

}  // namespace
}  // namespace asv::core
