#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string_view>
#include <vector>

#include "core/search/trees/tree.hpp"

namespace asv::core {

/// Why a search ended.
enum class Outcome { solved, iterations, nodes, deadline, stopped };

std::string_view name(Outcome outcome);

/// Configurations one after the other in one block, each joined to the next by a proven straight
/// motion; the dimension is that of the space.
using Configurations = std::vector<double>;

/// What steering toward a configuration came to (LaValle and Kuffner, 2001).
enum class Steered {
    trapped,   ///< no progress at all
    advanced,  ///< came nearer
    reached    ///< is there
};

/// What a search found and what it spent.
struct SearchResult {
    Outcome outcome = Outcome::iterations;
    Configurations path;  ///< from start to goal; empty unless solved
    /// That of the start, that of the goal; one tree only, or the nodes of a roadmap as roots.
    std::vector<Tree> trees;
    std::vector<std::array<std::uint32_t, 2>> edges;  ///< of a roadmap: pairs of nodes
    std::size_t iterations = 0;
};

/// A look at a search while it runs.
struct Progress {
    std::size_t iterations = 0;
    std::array<std::size_t, 2> nodes = {0, 0};
    /// Of the best path so far; infinite while there is none.
    double cost = std::numeric_limits<double>::infinity();
};

/// Is told of progress now and then; must not change the search.
using Observer = std::function<void(const Progress&)>;

}  // namespace asv::core
