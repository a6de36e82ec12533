#pragma once

#include <cstddef>
#include <string>

#include <gtest/gtest.h>

#include "core/space/sampling/shape_sampler.hpp"
#include "tests/kit/chains/configuration_oracle.hpp"
#include "tests/kit/seeds.hpp"

/// Random motions of chains among random boxes, and who can judge them.

namespace asv::test {

/// A world of n ASVs among random boxes, and motions in it.
struct MotionWorld {
    MotionWorld(core::Rng& rng, std::size_t n, std::size_t boxes, double size, core::Anchor anchor);

    /// A valid configuration.
    Row state(core::Rng& rng);

    /// To another place and shape, or only a little off, or changed in one respect alone.
    Row target(core::Rng& rng, const Row& from);

    /// Half of the motions begin where another one was blocked: in contact.
    Row beginning(core::Rng& rng);

    core::ChainWorld world;
    core::MotionChecker checker;
    core::ShapeSampler sampler;
    Oracle oracle;
};

/// So many ASVs among so many boxes with sides up to `size`.
struct MotionWorldKind {
    std::size_t asvs, boxes;
    double size;
    core::Anchor anchor;
};
inline constexpr MotionWorldKind motion_world_kinds[] = {
    {1, 30, 0.1, core::Anchor::first_asv}, {1, 30, 0.1, core::Anchor::centroid},
    {3, 10, 0.2, core::Anchor::centroid},  {3, 60, 0.06, core::Anchor::first_asv},
    {5, 40, 0.08, core::Anchor::centroid}, {7, 10, 0.1, core::Anchor::first_asv},
    {7, 60, 0.03, core::Anchor::centroid}, {15, 20, 0.06, core::Anchor::centroid},
};

/// Calls body(world, from, to) for random motions in worlds of every kind.
template <class Body>
void for_motions(std::size_t worlds, std::size_t motions, Body&& body) {
    for_seeds(worlds, [&](core::Rng& rng) {
        for (const MotionWorldKind& kind : motion_world_kinds) {
            SCOPED_TRACE(std::to_string(kind.asvs) + " ASVs, " + std::to_string(kind.boxes) +
                         " boxes");
            MotionWorld place(rng, kind.asvs, kind.boxes, kind.size, kind.anchor);
            for (std::size_t i = 0; i < motions; ++i) {
                SCOPED_TRACE("motion " + std::to_string(i));
                const Row from = place.beginning(rng);
                body(place, from, place.target(rng, from));
                if (::testing::Test::HasFailure()) return;
            }
        }
    });
}

}  // namespace asv::test
