#pragma once

#include <span>
#include <vector>

#include "asv/geometry/primitives.hpp"

namespace asv::core {

/// The boxes that remain of a solid box when passages are cut out of it: every maximal box of the
/// remainder that spans a row or a column of the grid through all sides. They overlap where one
/// wall meets another, so that there is no seam between them. Open passages: a remaining box may
/// touch a passage, never reach into it. All sides are first rounded to 1e-9, so that passages
/// whose sides are meant to coincide do. Ordered, without duplicates, none inside another one.
/// Cost is about cubic in the number of passages for the worst layouts; mazes of 40 x 40 cells take
/// well below a second.
std::vector<geometry::Box> carve(const geometry::Box& solid,
                                 std::span<const geometry::Box> passages);

}  // namespace asv::core
