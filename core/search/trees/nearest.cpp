#include "core/search/trees/nearest.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "geometry/simd/row_distance.hpp"

namespace asv::core {

namespace {

using geometry::simd::block_rows;

/// Blocks whose distances are computed in one go.
constexpr std::size_t max_blocks = 32;

}  // namespace

NearestNeighbours::NearestNeighbours(std::span<const double> scales, WrappingAngles wrapping)
    : scales_(scales.begin(), scales.end()),
      period_(scales.size(), 0.f),
      inverse_period_(scales.size(), 0.f),
      query_(scales.size()) {
    for (std::size_t i = 0; i < scales.size(); ++i) {
        if (!wrapping.contains(i) || !(scales[i] > 0)) continue;
        period_[i] = static_cast<float>(2 * std::numbers::pi * scales[i]);
        inverse_period_[i] = 1 / period_[i];
    }
}

void NearestNeighbours::add(std::span<const double> row) {
    const std::size_t lane = size_ % block_rows;
    if (lane == 0) blocks_.resize(blocks_.size() + block_rows * scales_.size(), 0.f);
    float* block = blocks_.data() + (size_ / block_rows) * block_rows * scales_.size();
    for (std::size_t i = 0; i < scales_.size(); ++i)
        block[i * block_rows + lane] = static_cast<float>(row[i] * scales_[i]);
    ++size_;
}

/// Calls visit(first row, number of rows, squared distances) for each block of rows that holds one
/// whose squared distance is below bound(), and for some others.
template <class Bound, class Visit>
void NearestNeighbours::scan(std::span<const double> row, Bound&& bound, Visit&& visit) const {
    const std::size_t d = scales_.size();
    for (std::size_t i = 0; i < d; ++i) query_[i] = static_cast<float>(row[i] * scales_[i]);
    std::array<float, max_blocks * block_rows> squared;
    std::array<float, max_blocks> least;
    const std::size_t blocks = (size_ + block_rows - 1) / block_rows;
    for (std::size_t first = 0; first < blocks; first += max_blocks) {
        const std::size_t count = std::min(max_blocks, blocks - first);
        geometry::simd::squared_distances(
            std::span(blocks_).subspan(first * block_rows * d, count * block_rows * d),
            {query_, period_, inverse_period_}, std::span(squared).first(count * block_rows),
            std::span(least).first(count));
        for (std::size_t b = 0; b < count; ++b) {
            if (!(least[b] < bound())) continue;
            const std::size_t start = (first + b) * block_rows;
            visit(start, std::min(block_rows, size_ - start), squared.data() + b * block_rows);
        }
    }
}

std::size_t NearestNeighbours::nearest(std::span<const double> row) const {
    std::size_t best = 0;
    float least = std::numeric_limits<float>::infinity();
    scan(
        row, [&] { return least; },
        [&](std::size_t start, std::size_t count, const float* squared) {
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
    constexpr float infinity = std::numeric_limits<float>::infinity();
    std::optional<std::size_t> best;
    float least = infinity;
    scan(
        row, [&] { return infinity; },
        [&](std::size_t start, std::size_t count, const float* squared) {
            for (std::size_t l = 0; l < count; ++l) {
                const float factor = factors[start + l];
                const float scaled = squared[l] * factor * factor;
                if (factor < infinity && scaled < least) {
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
    if (count == 0) return {};
    // A heap, the farthest on top, that holds the nearest so far.
    std::vector<std::pair<float, std::size_t>> found;
    const float beyond = std::nextafter(most, std::numeric_limits<float>::infinity());
    const auto bound = [&] { return found.size() < count ? beyond : found.front().first; };
    scan(row, bound, [&](std::size_t start, std::size_t rows, const float* squared) {
        for (std::size_t l = 0; l < rows; ++l) {
            if (!(squared[l] < bound())) continue;
            if (found.size() == count) {
                std::pop_heap(found.begin(), found.end());
                found.pop_back();
            }
            found.emplace_back(squared[l], start + l);
            std::push_heap(found.begin(), found.end());
        }
    });
    std::sort_heap(found.begin(), found.end());
    std::vector<std::size_t> result;
    result.reserve(found.size());
    for (const auto& [distance, index] : found) result.push_back(index);
    return result;
}

}  // namespace asv::core
