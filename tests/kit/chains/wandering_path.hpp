#pragma once

#include <cstddef>

#include "core/search/rng.hpp"
#include "core/space/chain_world.hpp"
#include "core/space/steering/slide.hpp"
#include "tests/kit/chains/configurations.hpp"

namespace asv::test {

/// Lets the path go on from its last configuration by so many slides to random ones.
void wander(core::MotionChecker& checker, core::SlideSteering& steering, core::Rng& rng, int legs,
            core::Configurations& path);

/// A world and a valid path that wanders about in it from its start.
struct Wanderer {
    Wanderer(core::Rng& rng, const core::Problem& problem, int legs);

    /// In a world of n ASVs among some boxes.
    Wanderer(core::Rng& rng, std::size_t n, int legs);

    /// Asserts that the other path begins and ends where this one does, bit by bit.
    void expect_same_ends(const core::Configurations& other) const;

    core::ChainWorld world;
    core::MotionChecker checker;
    core::SlideSteering steering;
    core::Configurations path;
};

}  // namespace asv::test
