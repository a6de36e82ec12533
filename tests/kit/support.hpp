#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/chain/chain.hpp"
#include "core/model/problem.hpp"
#include "core/search/rng.hpp"
#include "core/space/steering/slide.hpp"

/// What the tests of core share: seeds, hand-made chains and problems.

namespace asv::core::testing {

using Points = std::vector<Point>;
using Row = std::vector<double>;

/// The count, or the share of it that the environment variable ASV_TEST_SCALE asks for, where a
/// build is slow; at least 1.
std::size_t scaled(std::size_t count);

/// Calls body(rng) for the seeds 1, 2, ..., count. A failure names its seed and ends the loop.
template <class Body>
void for_seeds(std::size_t count, Body&& body) {
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        Rng rng(seed);
        body(rng);
        if (::testing::Test::HasFailure()) return;
    }
}

/// n ASVs, each broom turned by `turn` against the one before; brooms are 0.05 long.
Points arc(std::size_t n, Point first, double heading, double turn);

/// n ASVs around their centroid on most of a regular polygon: valid for every n but 2, and with
/// room in every requirement; counter-clockwise. `closing` in (0, 1] is the share of the polygon's
/// turns: with 1 the closing side is as long as a broom.
Points ring(std::size_t n, Point centroid, double heading, double closing = 0.93);

Points moved(Points points, double dx, double dy);
/// The other way along the chain.
Points reversed(Points points);

/// A problem from one place to another in the unit square; bounds may be widened for long chains.
Problem problem(Points start, Points goal, std::vector<Box> obstacles = {});

/// Random boxes with sides from 0.01 to `size` that do not meet start or goal with some room.
std::vector<Box> clutter(Rng& rng, std::size_t count, double size, const Problem& around);

/// A ring of n ASVs that shall cross the square among so many such boxes.
Problem cluttered(Rng& rng, std::size_t n, std::size_t count, double size);

/// The row of the positions. The mean heading's whole turns are those of the chain's own.
Row row_of(const Chain& chain, const Points& positions);

/// The row's positions by the textbook and the C library, sharing no code with Chain.
Points positions_of(const Chain& chain, std::span<const double> row);

/// a + t * (b - a).
Row between(std::span<const double> a, std::span<const double> b, double t);

/// The sum of measure(positions before, positions after) over so many short pieces of each motion.
double along(const Chain& chain, const Configurations& rows, int pieces,
             const std::function<double(const Points& before, const Points& after)>& measure);

/// Lets the path go on from its last row by so many slides to random configurations.
void wander(MotionChecker& checker, SlideSteering& steering, Rng& rng, int legs,
            Configurations& path);

/// Row i of a block of rows.
inline std::span<const double> nth(const std::vector<double>& rows, std::size_t dimension,
                                   std::size_t i) {
    return {rows.data() + i * dimension, dimension};
}

}  // namespace asv::core::testing
