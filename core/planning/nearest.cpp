#include "asv/core/planning/nearest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace asv::core {

NearestNeighbours::NearestNeighbours(std::span<const double> scales, WrappingAngles wrapping)
    : scales_(scales.begin(), scales.end()), wrapping_(wrapping), query_(scales.size()) {}

void NearestNeighbours::add(std::span<const double> row) {
    const std::size_t lane = size_ % lanes;
    if (lane == 0) blocks_.resize(blocks_.size() + lanes * scales_.size(), 1e18f);
    float* block = blocks_.data() + (size_ / lanes) * lanes * scales_.size();
    for (std::size_t i = 0; i < scales_.size(); ++i)
        block[i * lanes + lane] = static_cast<float>(row[i] * scales_[i]);
    ++size_;
}

/// Calls visit(first row, squared distances) for each block of rows.
template <class Visit>
void NearestNeighbours::scan(std::span<const double> row, Visit&& visit) const {
    const std::size_t d = scales_.size();
    for (std::size_t i = 0; i < d; ++i) query_[i] = static_cast<float>(row[i] * scales_[i]);
    constexpr float round_to_integer = 12582912.f;  // 1.5 * 2^23
    for (std::size_t start = 0; start < size_; start += lanes) {
        const float* block = blocks_.data() + start * d;
        float sum[lanes] = {};
        for (std::size_t i = 0; i < d; ++i) {
            const float q = query_[i];
            const float* values = block + i * lanes;
            if (wrapping_.contains(i) && scales_[i] > 0) {
                const auto period = static_cast<float>(2 * std::numbers::pi * scales_[i]);
                const float inverse = 1 / period;
                for (std::size_t l = 0; l < lanes; ++l) {
                    float difference = values[l] - q;
                    difference -=
                        period * ((difference * inverse + round_to_integer) - round_to_integer);
                    sum[l] += difference * difference;
                }
            } else {
                for (std::size_t l = 0; l < lanes; ++l) {
                    const float difference = values[l] - q;
                    sum[l] += difference * difference;
                }
            }
        }
        visit(start, sum);
    }
}

std::size_t NearestNeighbours::nearest(std::span<const double> row) const {
    std::size_t best = 0;
    float least = std::numeric_limits<float>::infinity();
    scan(row, [&](std::size_t start, const float* squared) {
        const std::size_t count = std::min(lanes, size_ - start);
        for (std::size_t l = 0; l < count; ++l) {
            if (squared[l] < least) {
                least = squared[l];
                best = start + l;
            }
        }
    });
    return best;
}

std::optional<std::size_t> NearestNeighbours::nearest(std::span<const double> row,
                                                      std::span<const float> factors) const {
    std::optional<std::size_t> best;
    float least = std::numeric_limits<float>::infinity();
    scan(row, [&](std::size_t start, const float* squared) {
        const std::size_t count = std::min(lanes, size_ - start);
        for (std::size_t l = 0; l < count; ++l) {
            const float factor = factors[start + l];
            const float scaled = squared[l] * factor * factor;
            if (factor < std::numeric_limits<float>::infinity() && scaled < least) {
                least = scaled;
                best = start + l;
            }
        }
    });
    return best;
}

std::vector<std::size_t> NearestNeighbours::nearest(std::span<const double> row,
                                                    std::size_t count) const {
    return sorted(row, std::numeric_limits<float>::infinity(), count);
}

std::vector<std::size_t> NearestNeighbours::within(std::span<const double> row,
                                                   double radius) const {
    return sorted(row, static_cast<float>(radius * radius), size_);
}

std::vector<std::size_t> NearestNeighbours::sorted(std::span<const double> row, float most,
                                                   std::size_t count) const {
    std::vector<std::pair<float, std::size_t>> found;
    scan(row, [&](std::size_t start, const float* squared) {
        const std::size_t rows = std::min(lanes, size_ - start);
        for (std::size_t l = 0; l < rows; ++l)
            if (squared[l] <= most) found.emplace_back(squared[l], start + l);
    });
    count = std::min(count, found.size());
    const auto end = found.begin() + static_cast<std::ptrdiff_t>(count);
    std::partial_sort(found.begin(), end, found.end());
    std::vector<std::size_t> result;
    result.reserve(count);
    for (auto it = found.begin(); it != end; ++it) result.push_back(it->second);
    return result;
}

}  // namespace asv::core
