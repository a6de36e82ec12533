#include <algorithm>
#include <cmath>

#include <boost/math/distributions/binomial.hpp>

#include "core/benchmark/statistics/statistics.hpp"
#include "core/search/rng.hpp"

namespace asv::core::statistics {

namespace {

/// As many measurements as the sample has, drawn from it with replacement. `times` is scratch.
CensoredSample resample(const CensoredSample& sample, Rng& rng, std::vector<std::size_t>& times) {
    times.assign(sample.size(), 0);
    for (std::size_t draw = 0; draw < sample.size(); ++draw) ++times[rng.below(sample.size())];
    CensoredSample drawn{{}, 0, sample.limit};
    drawn.known.reserve(sample.size());
    for (std::size_t i = 0; i < sample.known.size(); ++i)
        drawn.known.insert(drawn.known.end(), times[i], sample.known[i]);
    drawn.censored = sample.size() - drawn.known.size();
    return drawn;
}

/// By value; a censored one, which is greater than its value, behind those that are known.
bool ascends(const CensoredValue& a, const CensoredValue& b) {
    return a.value < b.value || (a.value == b.value && !a.censored && b.censored);
}

/// The value at this place; censored where one at or below it is, since that one may be greater.
CensoredValue at(const std::vector<CensoredValue>& ascending, std::size_t place) {
    const auto end = ascending.begin() + static_cast<std::ptrdiff_t>(place) + 1;
    return {ascending[place].value,
            std::any_of(ascending.begin(), end,
                        [](const CensoredValue& value) { return value.censored; })};
}

}  // namespace

Interval success_interval(std::size_t successes, std::size_t trials, double confidence) {
    using Binomial = boost::math::binomial_distribution<double>;
    const auto n = static_cast<double>(trials), k = static_cast<double>(successes);
    const double outside = (1 - confidence) / 2;  // on either side
    return {Binomial::find_lower_bound_on_p(n, k, outside),
            Binomial::find_upper_bound_on_p(n, k, outside)};
}

CensoredInterval median_interval(const CensoredSample& sample, const BootstrapOptions& options) {
    Rng rng(options.seed);
    std::vector<std::size_t> times;
    std::vector<CensoredValue> medians;
    medians.reserve(options.resamples);
    for (std::size_t i = 0; i < options.resamples; ++i)
        medians.push_back(quantile(resample(sample, rng, times), 0.5));
    std::sort(medians.begin(), medians.end(), ascends);
    const double outside = (1 - options.confidence) / 2 * static_cast<double>(medians.size() - 1);
    const auto low = static_cast<std::size_t>(std::floor(outside));
    return {at(medians, low), at(medians, medians.size() - 1 - low)};
}

}  // namespace asv::core::statistics
