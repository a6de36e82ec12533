#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "core/search/limits.hpp"
#include "core/search/rng.hpp"
#include "core/search/search_result.hpp"
#include "core/shorten/improve.hpp"
#include "core/space/joint_space.hpp"

namespace asv::core {

/// Microseconds of a 2.8 GHz core, roughly, that so many checks take in a space of so many
/// dimensions.
double joint_work_of(std::uint64_t state_checks, std::uint64_t motion_checks,
                     std::size_t dimension);

/// Shortens the path of an arm or a point by straight shortcuts until the work is spent; once these
/// gain nothing more, the same with other paths. Ends at once when the path costs no more than
/// the lower bound. Returns the best path; on_better is told the cost of each. Work is counted in
/// microseconds of a 2.8 GHz core, see joint_work_of().
Configurations improve_joints(Configurations path, JointSpace& space,
                              const std::function<AnotherPath(Rng&)>& another, double lower_bound,
                              double work, const Limits& limits, Rng& rng,
                              const std::function<void(double)>& on_better = {});

/// What all motions of a path cost.
double path_cost(const JointSpace& space, const Configurations& path);

}  // namespace asv::core
