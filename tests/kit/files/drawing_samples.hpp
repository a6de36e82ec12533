#pragma once

#include <cstddef>
#include <vector>

#include "io/drawing/exhibit.hpp"
#include "tests/kit/chains/chains.hpp"

/// Small problems and solutions for the tests of pictures and players.

namespace asv::test {

using geometry::Box;

/// ASVs on an arc that turns by 4.2 in all, which encloses enough area; the first at the place.
Points wide_arc(std::size_t asv_count, Point place);

/// The arc moves along the way points, each ASV by at most the given step.
core::Solution translated_arc(std::size_t asv_count, const Points& way, double step = 0.001);

/// An arc on its way among obstacles, from the first way point to the last.
io::ExhibitInput sample(std::size_t asv_count, const Points& way, std::vector<Box> obstacles,
                        double step = 0.001);

/// A problem without a path: between start and goal there is a corridor that is too low.
io::ExhibitInput low_corridor();

/// Two walls with a gap between them, right across the square.
std::vector<Box> two_walls();

}  // namespace asv::test
