#include "core/routes/route_search.hpp"

#include <algorithm>
#include <utility>

#include "core/shorten/chain_shortener.hpp"
#include "core/space/slide_space.hpp"

namespace asv::core {

namespace {

/// Classes of ways whose routes are tried before anything else.
constexpr std::size_t classes_to_begin_with = 3;
/// A route along which a search failed gets so many times as many iterations next time.
constexpr double growth = 2;
/// Iterations of a search for another piece of a path, which is near at hand or not worth it.
constexpr std::size_t iterations_between = 300;
/// Microseconds that a search takes at least, whatever it counts, and the time that it takes in
/// units of what it counts.
constexpr double min_search_work = 50, uncounted = 1.2;
/// The best of the routes is taken so often; else one of the first class, half as often of the
/// second and so on.
constexpr double best_share = 0.5, next_class_share = 0.5;

}  // namespace

RouteSearch::RouteSearch(const ChainWorld& world, const RouteSearchOptions& options)
    : world_(world), options_(options), ways_(world.problem) {}

bool RouteSearch::has_untried(double best_cost) {
    while (!next_untried(best_cost) && classes_.size() < classes_to_begin_with)
        if (!add_next_way(best_cost)) return false;
    return next_untried(best_cost) != nullptr;
}

RouteSearch::Found RouteSearch::search_along_route(double best_cost, Rng& rng) {
    Route& route = choose(best_cost, rng);
    last_ = &route;
    route.tried = true;
    const Limits limits = with_patience(options_.limits, route.patience);
    Found found = search(*route.world, {world_.start, world_.goal}, route.leader, limits, rng);
    if (found.path.empty()) route.patience *= growth;
    found.work += ways_.work() - std::exchange(work_of_ways_, ways_.work());
    return found;
}

void RouteSearch::note_cost(double cost) {
    last_->best_cost = std::min(last_->best_cost, cost);
}

RouteSearch::Found RouteSearch::search_between(const Query& query, Leader leader, Rng& rng) {
    Limits limits = options_.limits;
    limits.max_iterations = std::min(limits.max_iterations, iterations_between);
    return search(world_, query, leader, limits, rng);
}

/// Adds the routes of the next class of ways; false when no other can be better. The first class
/// leaves the leader open as well: what no route explains is left to chance.
bool RouteSearch::add_next_way(double best_cost) {
    if (!more_ways_) return false;
    std::optional<Way> way = ways_.next();
    const bool first = classes_.empty();
    more_ways_ = way && (first || way->bound < best_cost);
    if (!more_ways_) return false;
    classes_.push_back(std::move(*way));
    const Way& added = classes_.back();
    const ChainWorld* world = &world_;
    if (!added.closed.empty()) {
        closed_worlds_.push_back(std::make_unique<ChainWorld>(
            with_closed_gates(world_.problem, added.closed), Anchor::centroid));
        world = closed_worlds_.back().get();
    }
    for (const Leader leader : {Leader::last_asv, Leader::first_asv})
        routes_.push_back({&added, world, leader});
    if (first) routes_.push_back({&added, world, Leader::either});
    return true;
}

RouteSearch::Route* RouteSearch::next_untried(double best_cost) {
    const auto untried = std::find_if(routes_.begin(), routes_.end(), [&](const Route& route) {
        return !route.tried && route.way->bound < best_cost;
    });
    return untried == routes_.end() ? nullptr : &*untried;
}

RouteSearch::Route& RouteSearch::choose(double best_cost, Rng& rng) {
    if (has_untried(best_cost)) return *next_untried(best_cost);
    if (rng.chance(best_share))
        return *std::min_element(
            routes_.begin(), routes_.end(),
            [](const Route& a, const Route& b) { return a.best_cost < b.best_cost; });
    std::size_t rank = 0;
    while (rng.chance(next_class_share) && is_promising(rank + 1, best_cost)) ++rank;
    std::vector<Route*> of_class;
    for (Route& route : routes_)
        if (route.way == &classes_[rank]) of_class.push_back(&route);
    return *of_class[rng.below(of_class.size())];
}

/// Is there a class of that rank, and its bound below that cost?
bool RouteSearch::is_promising(std::size_t rank, double best_cost) {
    while (rank >= classes_.size())
        if (!add_next_way(best_cost)) return false;
    return classes_[rank].bound < best_cost;
}

RouteSearch::Found RouteSearch::search(const ChainWorld& world, const Query& query, Leader leader,
                                       const Limits& limits, Rng& rng) {
    SlideAndPullOptions options = options_.search;
    options.leader = leader;
    SlideSpace space(world, options_.steering);
    Found found;
    found.path = slide_and_pull(space, query, options, limits, rng).path;
    state_checks_ += space.checker().state_checks();
    motion_checks_ += space.checker().motion_checks();
    const ChainWork done{space.checker().state_checks(), space.constrained_steps(), 0};
    found.work = std::max(
        min_search_work,
        uncounted * microseconds(done, world.problem.asv_count(), world.problem.obstacles.size()));
    return found;
}

}  // namespace asv::core
