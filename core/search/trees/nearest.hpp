#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace asv::core {

/// The coordinates first, ..., first + count - 1 of a configuration are angles that wrap at 2 pi.
struct WrappingAngles {
    std::size_t first = 0, count = 0;

    bool contains(std::size_t coordinate) const {
        return coordinate >= first && coordinate - first < count;
    }
    friend bool operator==(const WrappingAngles&, const WrappingAngles&) = default;
};

/// Nearest neighbours among a growing set of rows, Euclidean after scaling; some coordinates may be
/// angles that wrap at 2 pi. The rows are scanned, many of them at a time.
class NearestNeighbours {
  public:
    /// scales: what each coordinate is multiplied by.
    NearestNeighbours(std::span<const double> scales, WrappingAngles wrapping);

    std::size_t dimension() const { return scales_.size(); }
    std::size_t size() const { return size_; }
    void add(std::span<const double> row);
    /// The index of the nearest row, the first one of several. Precondition: size() > 0.
    std::size_t nearest(std::span<const double> row) const;
    /// The same with the distance to each row multiplied by its factor; a factor of infinity hides
    /// the row. None when all are hidden. Precondition: factors.size() == size(), none negative.
    std::optional<std::size_t> nearest(std::span<const double> row,
                                       std::span<const float> factors) const;
    /// The count nearest rows, or all when there are fewer, the nearest first, then by index.
    std::vector<std::size_t> nearest(std::span<const double> row, std::size_t count) const;
    /// The rows within the closed ball, the nearest first, then by index. In single precision: what
    /// lies within some 1e-6 of the radius may fall on either side.
    std::vector<std::size_t> within(std::span<const double> row, double radius) const;

  private:
    template <class Bound, class Visit>
    void scan(std::span<const double> row, Bound&& bound, Visit&& visit) const;
    std::vector<std::size_t> sorted(std::span<const double> row, float most,
                                    std::size_t count) const;

    std::vector<double> scales_;
    std::vector<float> period_, inverse_period_;  ///< of each coordinate; 0 if it does not wrap
    std::size_t size_ = 0;
    std::vector<float> blocks_;  ///< as geometry::simd::squared_distances takes them
    mutable std::vector<float> query_;
};

}  // namespace asv::core
