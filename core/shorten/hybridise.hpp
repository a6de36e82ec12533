#pragma once

#include "core/search/search_result.hpp"
#include "core/shorten/shortcutter.hpp"
#include "core/space/metric.hpp"
#include "core/space/motion_cost.hpp"

namespace asv::core {

/// The best of two paths and of all that come of changing from one to the other: path
/// hybridisation (Raveh, Enosh and Halperin, 2011). Each way point of a path is bridged to the one
/// of the other path that is nearest, where the bridge can be built; the result is the shortest
/// path in the graph of both paths and their bridges.
/// Precondition: both lead from the same start to the same goal; headings that have made another
/// number of full turns at the goal count as another goal, and `path` is returned.
Configurations hybridise(const Configurations& path, const Configurations& other,
                         const Metric& metric, MotionCost& cost, const Bridge& bridge);

}  // namespace asv::core
