#pragma once

#include "core/routes/route_search.hpp"
#include "core/shorten/chain_shortener.hpp"
#include "core/shorten/improve.hpp"

namespace asv::core {

/// Shortens the path of a chain, and looks for better ones: along other routes from start to goal
/// (RouteSearch), and by new searches for random pieces of the best path. Each that is found is
/// shortened in stages and dropped as soon as it falls behind; what gets to the end is crossed with
/// the best. Returns the best path. `options.another` is not used.
Configurations improve_along_routes(Configurations path, const ChainWorld& world,
                                    ChainShortener& shortener, RouteSearch& routes,
                                    const ImproveOptions& options, Rng& rng);

}  // namespace asv::core
