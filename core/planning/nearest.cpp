#include "asv/core/planning/nearest.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace asv::core {

NearestNeighbours::NearestNeighbours(std::span<const double> scales,
                                     std::optional<std::size_t> wrapping)
    : scales_(scales.begin(), scales.end()), wrapping_(wrapping), query_(scales.size()) {}

void NearestNeighbours::add(std::span<const double> row) {
    const std::size_t lane = size_ % lanes;
    if (lane == 0) blocks_.resize(blocks_.size() + lanes * scales_.size(), 1e18f);
    float* block = blocks_.data() + (size_ / lanes) * lanes * scales_.size();
    for (std::size_t i = 0; i < scales_.size(); ++i)
        block[i * lanes + lane] = static_cast<float>(row[i] * scales_[i]);
    ++size_;
}

std::size_t NearestNeighbours::nearest(std::span<const double> row) const {
    for (std::size_t i = 0; i < scales_.size(); ++i)
        query_[i] = static_cast<float>(row[i] * scales_[i]);
    std::size_t best = 0;
    float least = std::numeric_limits<float>::infinity();
    const std::size_t d = scales_.size();
    const std::size_t wrapping = wrapping_.value_or(d);
    const auto period =
        wrapping < d ? static_cast<float>(2 * std::numbers::pi * scales_[wrapping]) : 1.f;
    const float inverse = 1 / period;
    constexpr float round_to_integer = 12582912.f;  // 1.5 * 2^23
    for (std::size_t start = 0; start < size_; start += lanes) {
        const float* block = blocks_.data() + start * d;
        float sum[lanes] = {};
        for (std::size_t i = 0; i < d; ++i) {
            const float q = query_[i];
            const float* values = block + i * lanes;
            if (i == wrapping) {
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
        const std::size_t count = std::min(lanes, size_ - start);
        for (std::size_t l = 0; l < count; ++l) {
            if (sum[l] < least) {
                least = sum[l];
                best = start + l;
            }
        }
    }
    return best;
}

}  // namespace asv::core
