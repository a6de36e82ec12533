#include "tests/kit/chains/motion_worlds.hpp"

#include <algorithm>
#include <cmath>

#include "core/search/trees/interpolate.hpp"
#include "tests/kit/chains/problems.hpp"

namespace asv::test {

MotionWorld::MotionWorld(core::Rng& rng, std::size_t n, std::size_t boxes, double size,
                         core::Anchor anchor)
    : world(cluttered(rng, n, boxes, size), anchor),
      checker(world.make_checker()),
      sampler(checker),
      oracle(world) {}

Row MotionWorld::state(core::Rng& rng) {
    Row row(world.start);
    while (!sampler.sample(rng, row)) continue;
    return row;
}

Row MotionWorld::target(core::Rng& rng, const Row& from) {
    const std::size_t kind = rng.below(5);
    if (kind == 0) {
        Row to = state(rng);
        core::unwrap(to, from, core::WrappingAngles{2, to.size() > 2 ? 1U : 0U});
        return to;
    }
    Row to(from);
    const double size = std::pow(10, rng.uniform(-4, 0));
    for (std::size_t i = 0; i < to.size(); ++i) {
        if (kind == 2 && i >= 2) break;
        if (kind == 3 && i != 2) continue;
        if (kind == 4 && i < 3) continue;
        to[i] += size * rng.normal() * (i < 2 ? 0.2 : 1);
        if (i > 2) to[i] = std::abs(to[i]);
    }
    return to;
}

Row MotionWorld::beginning(core::Rng& rng) {
    const Row from = state(rng);
    if (rng.chance(0.5)) return from;
    const Row to = target(rng, from);
    return between(from, to, std::max(0.0, checker.valid_prefix(from, to, 1e-4)));
}

}  // namespace asv::test
