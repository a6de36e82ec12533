#pragma once

#include <cstddef>

namespace asv::core {

/// Settings of the C-space as the bidirectional RRT for ASVs uses it; each part can be switched
/// off.
struct LadderOptions {
    bool stepwise = true;            ///< sample dimension by dimension from anywhere
    bool corridor = true;            ///< sample with ASV 1 in a gap between obstacles
    bool corridor_reversed = true;   ///< sample with ASV n in a gap between obstacles
    double widest_corridor = 0.2;    ///< gap between obstacles that counts as a corridor, units
    bool limit_angles = true;        ///< sample no turn sharper than the sharpest of start and goal
    std::size_t lift_after = 50;     ///< failed samples in a row that lift the limit
    std::size_t lifted_for = 50;     ///< samples for which it stays lifted
    double heading_weight = 0.5;     ///< units per radian: heavy, so that no half turn is asked for
    bool enlarge = true;             ///< angle enlargement
    std::size_t enlarge_tries = 10;  ///< how often the angles open a little more
    double enlarge_share = 0.05;     ///< by which the turns shrink each time
    bool ladder = true;              ///< ladder moves
    double step = 0.001;             ///< resolution of steering, largest motion of an ASV
};

}  // namespace asv::core
