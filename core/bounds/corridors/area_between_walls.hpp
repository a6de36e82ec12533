#pragma once

#include <cstddef>

#include "core/model/requirements.hpp"

/// How much area a chain can enclose while it lies between two parallel walls, and with that how
/// far apart they have to be for a valid one.

namespace asv::core {

/// No chain that lies in a strip of this height encloses more area together with its closing side.
/// It need not be convex; each of its brooms may be as long as `longest_broom`. Rounded upwards.
///
/// Proof. Let m be the mean of the heights of the two ends above the lower wall, and eta how far a
/// place is below m; the ends themselves are at c and -c. The area is the integral of eta dx around
/// the polygon. The closing side adds nothing to it, a broom from eta to zeta at most
/// |eta + zeta| / 2 * sqrt(length^2 - (eta - zeta)^2). Seen in a mirror or from the other end where
/// need be, m is in the upper half of the strip and c from 0 to the upper wall. So m is in one of
/// some intervals, and for each of them a dynamic programme goes along the chain: from a start
/// between 0 and the upper wall to an end between -1 times that and 0, through any heights in
/// between that are in the strip for some m of the interval. The heights are divided into rows, and
/// each pair of rows adds what it can add at most.
///
/// Of more than 100 ASVs height * length is returned, which is more.
///
/// `finely` takes intervals of one row each, which is hardly sharper where the strip is low for the
/// chain, but what core/certificate_check can compare itself with.
///
/// Cost: some 10 * rows^2 * brooms operations, finely half of rows^3 * brooms. Preconditions:
/// asv_count >= 2, longest_broom > 0, height > 0.
double max_area_between_walls(std::size_t asv_count, double longest_broom, double height,
                              bool finely = false);

/// No valid chain of so many ASVs lies in a strip that is no higher; 0 where nothing is proven. At
/// most 0.3 % below the height at which the flattest chain has the area that is required, tolerance
/// included. Cost: six of the above.
double height_without_chains(std::size_t asv_count, const Requirements& requirements);

}  // namespace asv::core
