#pragma once

#include <cstddef>
#include <vector>

#include "geometry/primitives.hpp"
#include "tests/kit/random.hpp"

namespace asv::test {

/// Boxes in and around the unit square, of any size up to `largest`.
std::vector<geometry::Box> random_boxes(Random& random, std::size_t count, double largest);

/// The same, some sides as short as twice the validator's tolerance of 1e-5.
std::vector<geometry::Box> random_boxes_some_thin(Random& random, std::size_t count,
                                                  double largest);

}  // namespace asv::test
