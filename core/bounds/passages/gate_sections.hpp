#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/free_plane/gates.hpp"
#include "geometry/primitives.hpp"

namespace asv::core {

/// A thin rectangle across a gate, from one of its sides to the other; the whole gate where it lies
/// between two corners.
struct GateSection {
    std::array<std::size_t, 2> sides;
    std::size_t number;  ///< among the sections of the gate
    geometry::Box across;

    friend bool operator==(const GateSection&, const GateSection&) = default;
};

/// Some sections of a gate, first that in the middle, where a chain has least room in most
/// corridors. The others are at the ends: in a row of obstacles, the middle of the corridor is
/// where two of them meet.
/// walls: what the sides of the gate count. thickness: of a section, along the gate.
std::vector<GateSection> sections_of(const geometry::Gate& gate,
                                     std::span<const geometry::Box> walls, double thickness);

}  // namespace asv::core
