#include <algorithm>
#include <cmath>

#include "core/benchmark/statistics/statistics.hpp"

namespace asv::core::statistics {

namespace {

/// Where a quantile lies in a sample: between two neighbours in ascending order.
struct Place {
    std::size_t below = 0, above = 0;
    double fraction = 0;  ///< of the way from below to above
};

Place place_of(double share, std::size_t count) {
    const double place = share * static_cast<double>(count - 1);
    const auto below = static_cast<std::size_t>(place);
    const double fraction = place - static_cast<double>(below);
    return {below, fraction > 0 ? below + 1 : below, fraction};
}

}  // namespace

double quantile(std::span<const double> ascending, double share) {
    const Place place = place_of(share, ascending.size());
    return std::lerp(ascending[place.below], ascending[place.above], place.fraction);
}

CensoredValue quantile(const CensoredSample& sample, double share) {
    const Place place = place_of(share, sample.size());
    const auto value = [&](std::size_t i) {
        return i < sample.known.size() ? sample.known[i] : sample.limit;
    };
    return {std::lerp(value(place.below), value(place.above), place.fraction),
            place.above >= sample.known.size()};
}

Spread spread_of(std::vector<double> values) {
    Spread spread;
    spread.count = values.size();
    if (values.empty()) return spread;
    std::sort(values.begin(), values.end());
    spread.least = values.front();
    spread.median = quantile(values, 0.5);
    spread.greatest = values.back();
    const auto count = static_cast<double>(values.size());
    for (const double value : values) spread.mean += value / count;
    double squares = 0;
    for (const double value : values) squares += (value - spread.mean) * (value - spread.mean);
    if (values.size() > 1) spread.deviation = std::sqrt(squares / (count - 1));
    return spread;
}

double penalised_mean(const CensoredSample& sample, double penalty) {
    double sum = penalty * sample.limit * static_cast<double>(sample.censored);
    for (const double value : sample.known) sum += value;
    return sum / static_cast<double>(sample.size());
}

}  // namespace asv::core::statistics
