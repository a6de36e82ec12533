#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace asv::core::trajectory {

/// The steps of a path, with all moves of a vehicle divided by its acceleration limit, so that
/// every vehicle has the limit 1 and lengths are in seconds squared.
///
/// The length of a step is the Euclidean norm of the moves of all vehicles together. Along a path
/// that is measured so, to hurry and to turn are perpendicular for the vehicles as a whole.
struct ScaledSteps {
    std::size_t vehicles = 0;
    std::vector<double> lengths;     ///< of each step, positive
    std::vector<double> directions;  ///< of each step x and y of each vehicle's move, by its length
    /// Of each step: the greatest pace that the speed limits allow, which is its length by its
    /// time.
    std::vector<double> fastest;

    std::size_t size() const { return lengths.size(); }
    std::span<const double> direction(std::size_t step) const {
        return {directions.data() + step * 2 * vehicles, 2 * vehicles};
    }
};

/// The pace at each step. With u and u' for the paces of two neighbouring steps, e and e' for a
/// vehicle's directions there and l and l' for their lengths, every vehicle keeps
///
///     |e' u' - e u| <= (l / u + l' / u') / 2,
///
/// the limit of core/model/trajectory.hpp. Alone it would let a step take so long that any jump of
/// a velocity at its ends was excused. So where one pace is more than 1 + sqrt(2) times the other,
/// which is how the first two steps from rest differ, it also keeps
///
///     |e' u' - e u| <= (l + l') / (u + u'),
///
/// on a straight run the law of even acceleration, |u'^2 - u^2| <= l + l'.
std::vector<double> paces(const ScaledSteps& steps);

}  // namespace asv::core::trajectory
