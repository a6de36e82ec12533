#include "core/space/steering/near_constraints.hpp"

#include <vector>

#include "core/space/chain_world.hpp"
#include "core/space/sampling/shape_sampler.hpp"
#include "tests/kit/chains/configurations.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using test::for_seeds;
using test::moved_by;
using test::ring;
using test::Row;
using test::scaled;

TEST(NearConstraints, GradientsAreThoseOfTheGaps) {
    std::size_t kinds[7] = {};
    for_seeds(scaled(60), [&](Rng& rng) {
        const std::size_t n = 1 + rng.below(9);
        Problem problem =
            test::problem(ring(n == 2 ? 3 : n, {0.3, 0.3}, 1), ring(n == 2 ? 3 : n, {0.7, 0.7}, 2));
        problem.obstacles = test::clutter(rng, 25, 0.08, problem);
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

}  // namespace
}  // namespace asv::core
