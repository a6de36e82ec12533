#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/chain/batch/chain_batch.hpp"
#include "tests/kit/geometry/adversary.hpp"

/// Chains in the form x, y, headings, and boxes on which their collisions hang by an ulp.

namespace asv::test {

/// x, y and the heading of every broom.
using HeadingRow = std::vector<double>;

/// Positions by the stated formula, one operation after the other: bit by bit those of a kernel.
std::vector<geometry::Point> kernel_positions(const HeadingRow& row,
                                              const core::batch::ChainLimits& limits);

/// So many chains; every eighth may violate any limit, the others collide at most.
std::vector<HeadingRow> random_chains(std::size_t points, std::size_t count, Random& random,
                                      const core::batch::ChainLimits& limits);

/// Squares, long walls, degenerate and empty boxes, and some that touch a link of the chains in a
/// corner, within an ulp.
std::vector<geometry::Box> hard_boxes(std::size_t count, std::span<const HeadingRow> chains,
                                      const core::batch::ChainLimits& limits, Adversary& draw);

}  // namespace asv::test
