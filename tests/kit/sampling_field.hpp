#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "tests/kit/chains/configuration_oracle.hpp"
#include "tests/kit/chains/problems.hpp"

namespace asv::test {

/// A world to draw configurations in, and who judges them.
struct SamplingField {
    SamplingField(std::size_t n, std::vector<Box> boxes, core::Anchor anchor)
        : world(problem(ring(n, {0.25, 0.25}, 0), ring(n, {0.75, 0.75}, 0), std::move(boxes)),
                anchor),
          checker(world.make_checker()),
          oracle(world) {}

    core::ChainWorld world;
    core::MotionChecker checker;
    Oracle oracle;
};

/// One box in the middle of the unit square.
inline std::vector<Box> box_in_the_middle() {
    return {{{0.45, 0.45}, {0.55, 0.55}}};
}

}  // namespace asv::test
