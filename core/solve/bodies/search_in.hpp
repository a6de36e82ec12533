#pragma once

#include <algorithm>

#include "core/solve/planner_catalogue.hpp"

/// How each planner searches in a space, whatever the body. Lengths that are 0 in the options
/// become shares of the longest side of the space here.

namespace asv::core {

/// The longest side of the bounds, in the metric.
template <SampledSpace Space>
double longest_side(const Space& space) {
    double longest = 0;
    for (std::size_t i = 0; i < space.dimension(); ++i)
        longest = std::max(longest, static_cast<double>(space.extent(i)));
    return longest;
}

/// The length, or the share of the longest side if it is 0.
template <SampledSpace Space>
double length_or_share(const Space& space, double length, double share) {
    return length > 0 ? length : share * longest_side(space);
}

/// The sampler of the options for a space like the given one.
template <SampledSpace Space>
Sampler<Space> sampler_for(const Space& space, SamplerOptions options) {
    options.sigma = length_or_share(space, options.sigma, 0.05);
    return make_sampler<Space>(options);
}

/// With the extensions that are on.
template <SampledSpace Space>
SearchResult rrt_connect_in(Space& space, const RrtConnectPlanner& planner, const Query& query,
                            const Limits& limits, Rng& rng, const Observer& observer) {
    if (!planner.extensions.any())
        return rrt_connect(space, query, planner.search, limits, rng, observer);
    ExtensionOptions options = planner.extensions;
    options.swap_step = length_or_share(space, options.swap_step, 0.001);
    options.passage_filter.sigma = length_or_share(space, options.passage_filter.sigma, 0.05);
    return rrt_connect(space, query, planner.search, limits, rng, observer,
                       Extensions(query, options));
}

template <SampledSpace Space>
SearchResult search_in(Space& space, const RrtConnectPlanner& planner, const Query& query,
                       const Limits& limits, Rng& rng, const Observer& observer) {
    SingleStepOptions options = planner.single_steps;
    if (options.extend == ExtendBy::whole)
        return rrt_connect_in(space, planner, query, limits, rng, observer);
    options.step = length_or_share(space, options.step, 0.001);
    SingleSteps<Space> stepping(space, options);
    return rrt_connect_in(stepping, planner, query, limits, rng, observer);
}

template <SampledSpace Space>
SearchResult search_in(Space& space, const RrtPlanner& planner, const Query& query,
                       const Limits& limits, Rng& rng, const Observer& observer) {
    RrtOptions options = planner.search;
    options.step = length_or_share(space, options.step, 0.1);
    return rrt(space, query, options, limits, rng, observer);
}

template <SampledSpace Space>
SearchResult search_in(Space& space, const RrtStarPlanner& planner, const Query& query,
                       const Limits& limits, Rng& rng, const Observer& observer) {
    RrtStarOptions options = planner.search;
    options.step = length_or_share(space, options.step, 0.1);
    return rrt_star(space, query, options, limits, rng, observer);
}

template <SampledSpace Space>
SearchResult search_in(Space& space, const PrmPlanner& planner, const Query& query,
                       const Limits& limits, Rng& rng, const Observer& observer) {
    return prm(space, query, planner.search, limits, rng, observer);
}

}  // namespace asv::core
