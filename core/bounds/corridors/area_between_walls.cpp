#include "core/bounds/corridors/area_between_walls.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace asv::core {

namespace {

/// So many fill the strip. Enough to come within some thousandths of the flattest chain.
constexpr std::size_t rows = 256;

/// Longer chains would take a second.
constexpr std::size_t most_asvs_in_rows = 100;

/// Far more than what the sums of some hundred positive numbers lose by rounding, and far
/// less than what the rows lose.
constexpr double rounding_of_sums = 1e-12;

constexpr double unreachable = -std::numeric_limits<double>::infinity();

/// How far a broom gets along the strip at most, by how many rows it goes up or down; `unreachable`
/// where it is too short for that. From 2 * rows down to as many up.
std::vector<double> farthest_along(double broom, double row_height) {
    constexpr std::size_t level = 2 * rows;
    std::vector<double> along(2 * level + 1, unreachable);
    for (std::size_t apart = 0; apart <= level; ++apart) {
        // Rows next to each other have a height in common.
        const double climb = row_height * static_cast<double>(apart > 1 ? apart - 1 : 0);
        if (climb > broom) break;
        along[level - apart] = along[level + apart] = std::sqrt(broom * broom - climb * climb);
    }
    return along;
}

/// The greatest |eta + zeta| / 2, in heights of a row, for heights in two rows, by the sum of their
/// indices, where the first row is so many below 0.
std::vector<double> greatest_means(std::size_t below, std::size_t count) {
    std::vector<double> means(2 * count - 1);
    for (std::size_t sum = 0; sum < means.size(); ++sum) {
        const double middle = static_cast<double>(sum) + 1 - 2 * static_cast<double>(below);
        means[sum] = (std::abs(middle) + 1) / 2;
    }
    return means;
}

/// The greatest sum along the chain, in heights of a row times the unit: from the `ends` rows above
/// 0 to as many below it, through these and all others up to `above`. Row k holds the heights from
/// k to k + 1 times that of a row.
double most_along_chain(std::size_t asv_count, const std::vector<double>& along, std::size_t ends,
                        std::size_t above) {
    const std::size_t count = ends + above;
    const std::vector<double> means = greatest_means(ends, count);
    std::vector<double> area(count, unreachable), next(count);
    const auto zero = area.begin() + static_cast<std::ptrdiff_t>(ends);
    std::fill(zero, zero + static_cast<std::ptrdiff_t>(ends), 0.0);
    for (std::size_t broom = 1; broom < asv_count; ++broom) {
        std::fill(next.begin(), next.end(), unreachable);
        for (std::size_t from = 0; from < count; ++from) {
            const double* along_to = along.data() + 2 * rows - from;
            const double* mean = means.data() + from;
            for (std::size_t to = 0; to < count; ++to)
                next[to] = std::max(next[to], area[from] + mean[to] * along_to[to]);
        }
        area.swap(next);
    }
    return *std::max_element(area.begin(), area.begin() + static_cast<std::ptrdiff_t>(ends));
}

}  // namespace

double max_area_between_walls(std::size_t asv_count, double longest_broom, double height,
                              bool finely) {
    if (asv_count > most_asvs_in_rows)
        return height * longest_broom * static_cast<double>(asv_count - 1) * (1 + rounding_of_sums);
    const double row_height = height * (1 + rounding_of_sums) / static_cast<double>(rows);
    const std::vector<double> along = farthest_along(longest_broom, row_height);
    // How many rows m is below the upper wall: at most one, then from `last` to `ends`.
    double most = most_along_chain(asv_count, along, 1, rows);
    for (std::size_t last = 1; last < rows / 2;) {
        // As if every broom were level and as far from m as can be; less for all that follow.
        const auto farthest = static_cast<double>((rows - last) * (asv_count - 1));
        if (farthest * longest_broom <= most) break;
        const std::size_t more = finely ? 1 : std::max<std::size_t>(1, last / 2);
        const std::size_t ends = std::min(last + more, rows / 2);
        most = std::max(most, most_along_chain(asv_count, along, ends, rows - last));
        last = ends;
    }
    return most * row_height * (1 + rounding_of_sums);
}

double height_without_chains(std::size_t asv_count, const Requirements& requirements) {
    const double required = requirements.min_area(asv_count) - requirements.tolerance;
    if (asv_count < 3 || !(required > 0)) return 0;
    const double broom = requirements.broom_length + requirements.tolerance;
    const auto area_at = [&](double height) {
        return max_area_between_walls(asv_count, broom, height);
    };
    // A strip as long as the chain that has no more area than is required. The area grows about as
    // the height does, so that the next guess is nearly right.
    const double length = broom * static_cast<double>(asv_count - 1);
    double proven = required / length * (1 - 1e-9);
    double guess = proven;
    constexpr int guesses = 6;
    for (int i = 0; i < guesses && guess < length; ++i) {
        const double area = area_at(guess);
        if (area < required) proven = std::max(proven, guess);
        guess *= required / area * (1 - 1e-5);
    }
    return proven;
}

}  // namespace asv::core
