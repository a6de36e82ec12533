#pragma once

#include "core/space/proof/chain_constraints.hpp"
#include "core/space/proof/line_motion.hpp"
#include "core/space/proof/proven_stretch.hpp"

/// How far around a moment of a line each requirement on the chain itself is proven, by its gap,
/// the slope of that and a bound on its curvature. Each shortens the stretch to that, and returns
/// false where the requirement does not hold at the moment. `rounding`: by how much a gap may be
/// negative by rounding alone.

namespace asv::core {

/// Every ASV is in the bounds.
bool prove_bounds(const LineMotion& motion, const ChainConstraints& constraints,
                  ProvenStretch& stretch);

/// Convexity at the intermediate ASVs: their turns are in their range.
bool prove_turns(const LineMotion& motion, const ChainConstraints& constraints, double rounding,
                 ProvenStretch& stretch);

/// Convexity at both ends of the closing side, and its least length. Precondition: 3 ASVs or more.
bool prove_closing_side(const LineMotion& motion, const ChainConstraints& constraints,
                        double rounding, ProvenStretch& stretch);

/// Of the closed polygon. Precondition: 3 ASVs or more.
bool prove_area(const LineMotion& motion, const ChainConstraints& constraints, double rounding,
                ProvenStretch& stretch);

}  // namespace asv::core
