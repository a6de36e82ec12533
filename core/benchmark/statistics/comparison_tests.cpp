#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

#include <boost/math/distributions/normal.hpp>

#include "core/benchmark/statistics/statistics.hpp"

namespace asv::core::statistics {

namespace {

/// Up to so many ranks the exact distribution takes some milliseconds at most; beyond, the normal
/// one cannot be told from it.
constexpr std::size_t most_exact = 200;

/// Twice the rank of the magnitude of each difference: whole numbers, as ranks of ties are halves.
std::vector<std::size_t> doubled_ranks(std::span<const double> differences) {
    std::vector<std::size_t> order(differences.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto magnitude = [&](std::size_t i) { return std::abs(differences[i]); };
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return magnitude(i) < magnitude(j); });
    std::vector<std::size_t> ranks(differences.size());
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        while (end < order.size() && magnitude(order[end]) == magnitude(order[begin])) ++end;
        // The mean of the ranks begin + 1, ..., end, twice.
        for (std::size_t i = begin; i < end; ++i) ranks[order[i]] = begin + 1 + end;
    }
    return ranks;
}

/// The chance that the ranks with a positive sign sum up to no more than `least`, every sign being
/// as likely as the other.
double chance_of_sum_up_to(std::size_t least, std::span<const std::size_t> ranks) {
    std::vector<double> chances(least + 1, 0.0);  // of each sum; greater ones are of no interest
    chances[0] = 1;
    for (const std::size_t rank : ranks)
        for (std::size_t sum = least + 1; sum-- > 0;)
            chances[sum] = (chances[sum] + (sum >= rank ? chances[sum - rank] : 0)) / 2;
    return std::accumulate(chances.begin(), chances.end(), 0.0);
}

/// The same by the normal distribution, half a rank nearer to the mean for continuity.
double normal_chance_of_sum_up_to(std::size_t least, std::span<const std::size_t> ranks) {
    double mean = 0, variance = 0;
    for (const std::size_t rank : ranks) {
        const auto value = static_cast<double>(rank);
        mean += value / 2;
        variance += value * value / 4;
    }
    constexpr double half_a_rank = 1;  // doubled, as the ranks are
    const double distance = std::max(0.0, mean - static_cast<double>(least) - half_a_rank);
    const boost::math::normal_distribution<double> standard;
    return boost::math::cdf(standard, -distance / std::sqrt(variance));
}

}  // namespace

SignedRank signed_rank_test(std::span<const double> differences) {
    for (const double difference : differences)
        if (!std::isfinite(difference))
            throw std::invalid_argument("signed_rank_test: a difference is not finite");
    const std::vector<std::size_t> ranks = doubled_ranks(differences);
    std::vector<std::size_t> signed_ranks;
    std::size_t positive = 0, negative = 0;
    for (std::size_t i = 0; i < ranks.size(); ++i) {
        if (differences[i] == 0) continue;
        signed_ranks.push_back(ranks[i]);
        (differences[i] > 0 ? positive : negative) += ranks[i];
    }
    SignedRank result{differences.size(), signed_ranks.size(), static_cast<double>(positive) / 2,
                      static_cast<double>(negative) / 2};
    result.exact = signed_ranks.size() <= most_exact;
    if (signed_ranks.empty()) return result;
    const std::size_t least = std::min(positive, negative);
    const double one_sided = result.exact ? chance_of_sum_up_to(least, signed_ranks)
                                          : normal_chance_of_sum_up_to(least, signed_ranks);
    result.p = std::min(1.0, 2 * one_sided);
    return result;
}

std::vector<double> holm(std::span<const double> p) {
    std::vector<std::size_t> order(p.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return p[i] < p[j]; });
    std::vector<double> corrected(p.size());
    double greatest = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const double factor = static_cast<double>(order.size() - i);
        greatest = std::max(greatest, std::min(1.0, factor * p[order[i]]));
        corrected[order[i]] = greatest;
    }
    return corrected;
}

double chance_of_less(std::span<const double> first, std::span<const double> second) {
    std::vector<double> others(second.begin(), second.end());
    std::sort(others.begin(), others.end());
    double wins = 0;
    for (const double value : first) {
        const auto [equal, greater] = std::equal_range(others.begin(), others.end(), value);
        wins +=
            static_cast<double>(others.end() - greater) + static_cast<double>(greater - equal) / 2;
    }
    return wins / (static_cast<double>(first.size()) * static_cast<double>(second.size()));
}

}  // namespace asv::core::statistics
