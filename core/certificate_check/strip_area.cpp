#include "core/certificate_check/strip_area.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <vector>

namespace asv::core::certificate_check {

namespace {

/// The way that a broom makes along the strip is told in these parts of its length.
constexpr double parts_of_way = 0x1p30;

constexpr double unreachable = -std::numeric_limits<double>::infinity();

/// The greatest way along the strip between heights in rows so many apart, from -rows to rows, in
/// parts of a broom.
std::vector<double> greatest_ways(const Number& broom, const Number& row_height, std::size_t rows) {
    std::vector<double> ways(2 * rows + 1, unreachable);
    for (std::size_t apart = 0; apart <= rows; ++apart) {
        // Rows next to each other have a height in common.
        const Number climb = row_height * std::max<std::size_t>(apart, 1) - row_height;
        const Number left = 1 - climb * climb / (broom * broom);
        if (left < 0) break;
        const auto parts = whole(root_above(left) * exact(parts_of_way)) + 1;
        ways[rows - apart] = ways[rows + apart] = static_cast<double>(parts);
    }
    return ways;
}

/// The greatest area where m is in row `middle`, in half row heights times parts of a broom. The
/// heights d in the strip lie in rows -middle - 1 to rows - middle - 1, of which the first has the
/// index 0 here.
double greatest_sum(std::size_t brooms, const std::vector<double>& ways, std::size_t middle,
                    std::size_t rows) {
    const std::size_t zero = middle + 1, count = rows + 1;
    std::vector<double> factors(2 * count);  // the greatest |d + d'|, by the sum of two indices
    for (std::size_t sum = 0; sum < factors.size(); ++sum)
        factors[sum] = std::abs(static_cast<double>(sum) + 1 - 2 * static_cast<double>(zero)) + 1;
    std::vector<double> most(count, unreachable), next(count);
    std::fill(most.begin() + static_cast<std::ptrdiff_t>(zero), most.end(), 0.0);
    for (std::size_t broom = 0; broom < brooms; ++broom) {
        std::fill(next.begin(), next.end(), unreachable);
        for (std::size_t from = 0; from < count; ++from) {
            const double* factor = factors.data() + from;
            const double* way = ways.data() + rows - from;
            for (std::size_t to = 0; to < count; ++to)
                next[to] = std::max(next[to], most[from] + factor[to] * way[to]);
        }
        most.swap(next);
    }
    // As far below m at the end as above it at the start.
    const auto end = most.begin() + static_cast<std::ptrdiff_t>(zero);
    return *std::max_element(end - static_cast<std::ptrdiff_t>(rows - middle), end);
}

}  // namespace

Number strip_area_at_most(std::size_t asv_count, const Number& broom, const Number& height,
                          std::size_t rows) {
    if (height <= 0) return 0;
    const std::size_t brooms = asv_count - 1;
    if (asv_count > most_asvs_in_rows) return height * broom * brooms;
    const Number row_height = height / rows;
    const std::vector<double> ways = greatest_ways(broom, row_height, rows);
    double most = 0;
    for (std::size_t middle = rows; middle-- > rows / 2;) {
        // As much as if all brooms were level and as far from m as the strip is; the less, the
        // lower m is.
        const double at_most = static_cast<double>(brooms * 2 * (middle + 1)) * ways[rows];
        if (at_most <= most) break;
        most = std::max(most, greatest_sum(brooms, ways, middle, rows));
    }
    return exact(most) * row_height / 2 * broom / exact(parts_of_way);
}

}  // namespace asv::core::certificate_check
