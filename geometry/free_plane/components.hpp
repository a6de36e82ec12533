#pragma once

#include <cstdint>
#include <vector>

#include "geometry/free_plane/cell_graph.hpp"
#include "geometry/primitives.hpp"

namespace asv::geometry::detail {

/// Which cells of a graph are connected through portals. Remembers what it has found out.
class Components {
  public:
    /// Is there a way from the first cell to the second? Searches from both ends in turn, each
    /// towards the other, so that a small component is found out in time proportional to it.
    bool connected(CellGraph& graph, CellTree::Id from, CellTree::Id to);

  private:
    std::uint32_t find(std::uint32_t cell);
    void unite(std::uint32_t a, std::uint32_t b);
    void resize(std::size_t cells);

    std::vector<std::uint32_t> parent_;   ///< disjoint sets of cells that are known to be connected
    std::vector<std::uint8_t> complete_;  ///< at a set's representative: it is the whole component
};

}  // namespace asv::geometry::detail
