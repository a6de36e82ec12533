#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "core/routes/ways.hpp"
#include "core/search/limits.hpp"
#include "core/search/rng.hpp"
#include "core/search/slide_and_pull.hpp"
#include "core/space/chain_world.hpp"
#include "core/space/steering/slide_options.hpp"

namespace asv::core {

/// How the default planner is to search.
struct RouteSearchOptions {
    SlideOptions steering;
    SlideAndPullOptions search;
    Limits limits;  ///< of each search along a route; a route where they did not do gets more
};

/// Searches for paths along routes. A route is a class of ways through the plane together with the
/// end of the chain that leads: both decide what a path costs in the end, and a search on its own
/// leaves them to chance. Gates are closed in the world of the search alone, so that its paths are
/// valid in the true one.
class RouteSearch {
  public:
    /// The world outlives this.
    RouteSearch(const ChainWorld& world, const RouteSearchOptions& options);

    /// What a search came to.
    struct Found {
        Configurations path;  ///< empty where it failed
        double work = 0;      ///< microseconds, counted
    };

    /// Is there a route that was not tried yet, and its bound below that cost? Looks at the first
    /// few classes, and at others once search_along_route() has come to them.
    bool has_untried(double best_cost);

    /// Searches along the next route: one that was not tried yet, in the order of the bounds, or
    /// else by turns at random that of the best cost and any one, the sooner the lower its bound
    /// is; so it comes to further classes.
    Found search_along_route(double best_cost, Rng& rng);

    /// Tells what the path of that search costs once it is shortened, as far as it was.
    void note_cost(double cost);

    /// Searches between two configurations with this end in the lead.
    Found search_between(const Query& query, Leader leader, Rng& rng);

    /// Of all searches.
    std::uint64_t state_checks() const { return state_checks_; }
    std::uint64_t motion_checks() const { return motion_checks_; }

  private:
    struct Route {
        const Way* way;
        const ChainWorld* world;
        Leader leader;
        double patience = 1;
        bool tried = false;
        double best_cost = std::numeric_limits<double>::infinity();
    };

    bool add_next_way(double best_cost);
    Route* next_untried(double best_cost);
    Route& choose(double best_cost, Rng& rng);
    bool is_promising(std::size_t rank, double best_cost);
    Found search(const ChainWorld& world, const Query& query, Leader leader, const Limits& limits,
                 Rng& rng);

    const ChainWorld& world_;
    RouteSearchOptions options_;
    Ways ways_;
    bool more_ways_ = true;
    std::deque<Way> classes_;
    std::vector<std::unique_ptr<ChainWorld>> closed_worlds_;
    std::deque<Route> routes_;
    Route* last_ = nullptr;
    double work_of_ways_ = 0;  ///< that was charged
    std::uint64_t state_checks_ = 0, motion_checks_ = 0;
};

}  // namespace asv::core
