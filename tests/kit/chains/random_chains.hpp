#pragma once

#include <cstddef>
#include <vector>

#include "tests/kit/chains/chains.hpp"
#include "tests/kit/random.hpp"

/// Random chains, many of them near one limit of the validator or another.

namespace asv::test {

/// A chain of n >= 2 ASVs anywhere in the unit square, whose turns have one sign and add up to less
/// than a full turn; some joints are straight.
Points random_chain(Random& random, std::size_t n);

/// Moves each ASV by up to `size` in x and in y.
void shake(Random& random, Points& chain, double size);

}  // namespace asv::test
