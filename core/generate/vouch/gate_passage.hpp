#pragma once

#include <cstdint>
#include <vector>

#include "core/generate/vouch/proven_motions.hpp"

namespace asv::core {

/// A proven way through a gate, from the round chain on its left to the round chain on its right.
struct GatePassage {
    std::uint32_t left;
    std::uint32_t right;
    ProvenMotions::WayPoints way_points;

    /// The same way the other way round.
    void reverse();
};

/// One passage for each gate that a chain on some rail gets through. The effort is bounded by a
/// fixed number of motion checks, so that the answer does not depend on the machine. Empty where
/// there are more than 64 obstacles.
std::vector<GatePassage> gate_passages(ProvenMotions& motions);

}  // namespace asv::core
