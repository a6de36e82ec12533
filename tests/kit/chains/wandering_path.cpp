#include "tests/kit/chains/wandering_path.hpp"

#include <gtest/gtest.h>

#include "core/search/trees/interpolate.hpp"
#include "core/space/sampling/shape_sampler.hpp"
#include "tests/kit/chains/problems.hpp"

namespace asv::test {

void wander(core::MotionChecker& checker, core::SlideSteering& steering, core::Rng& rng, int legs,
            core::Configurations& path) {
    core::ShapeSampler sampler(checker);
    const std::size_t d = checker.chain().dimension();
    for (int leg = 0; leg < legs; ++leg) {
        const Row from(path.end() - static_cast<std::ptrdiff_t>(d), path.end());
        Row to(from);
        if (!sampler.sample(rng, to)) continue;
        core::unwrap(to, from, {2, d > 2 ? 1U : 0U});
        steering.slide(from, to, path);
    }
}

Wanderer::Wanderer(core::Rng& rng, const core::Problem& problem, int legs)
    : world(problem, core::Anchor::centroid),
      checker(world.make_checker()),
      steering(checker, world.metric, {}),
      path(world.start) {
    wander(checker, steering, rng, legs, path);
}

Wanderer::Wanderer(core::Rng& rng, std::size_t n, int legs)
    : Wanderer(rng, cluttered(rng, n, 15, 0.08), legs) {}

void Wanderer::expect_same_ends(const core::Configurations& other) const {
    const std::size_t d = world.chain.dimension();
    ASSERT_GE(other.size(), d);
    for (std::size_t i = 0; i < d; ++i) {
        ASSERT_EQ(other[i], path[i]);
        ASSERT_EQ(other[other.size() - d + i], path[path.size() - d + i]);
    }
}

}  // namespace asv::test
