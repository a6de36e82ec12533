#pragma once

#include "core/validation/collisions.hpp"
#include "core/validation/motion/motion_shape.hpp"

namespace asv::core::validation {

/// A broom whose ends move straight and at constant speed.
struct MovingBroom {
    Moving a;
    Moving b;
};

/// The first time that could not be proven free of contact with the closed box, within 1e-9; none
/// when the broom is proven to stay clear of it for all t in [0, 1]. Precondition: finite
/// coordinates, box not empty.
std::optional<double> first_contact(const MovingBroom& broom, const geometry::Box& box);

/// No broom meets an obstacle at any time of the motion; holds only when proven. Room: the least
/// of the clearances at a few times, for information; pairs that keep `radius` are passed over.
Finding check_motion_collisions(const Motion& motion, const Obstacles& obstacles, double radius);

}  // namespace asv::core::validation
