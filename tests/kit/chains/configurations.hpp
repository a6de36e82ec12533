#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "core/chain/chain.hpp"
#include "core/search/search_result.hpp"
#include "tests/kit/chains/chains.hpp"

/// Configurations of chains: made, read and measured without the code that is tested.

namespace asv::test {

/// One configuration.
using Row = std::vector<double>;

/// Configuration i of a block of them.
inline std::span<const double> nth(const std::vector<double>& rows, std::size_t dimension,
                                   std::size_t i) {
    return {rows.data() + i * dimension, dimension};
}

/// The configuration of the positions. The mean heading's whole turns are those of the chain's own.
Row row_of(const core::Chain& chain, const Points& positions);

/// The positions of a configuration by the textbook and the C library, sharing no code with Chain.
Points positions_of(const core::Chain& chain, std::span<const double> row);

/// a + t * (b - a).
Row between(std::span<const double> a, std::span<const double> b, double t);

/// The configuration moved by a step in the coordinates x, y, headings.
Row moved_by(const core::Chain& chain, std::span<const double> row, std::span<const double> step);

/// The sum of measure(positions before, positions after) over so many short pieces of each motion.
double along(const core::Chain& chain, const core::Configurations& rows, int pieces,
             const std::function<double(const Points& before, const Points& after)>& measure);

/// What the ASVs cover together, by very short chords.
double way(const core::Chain& chain, const core::Configurations& rows);

}  // namespace asv::test
