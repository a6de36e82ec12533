#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace asv::core {

/// Nearest neighbours among a growing set of rows, Euclidean after scaling; one coordinate may be
/// an angle that wraps at 2 pi. Few rows are scanned, many of them at a time.
class NearestNeighbours {
  public:
    /// scales: what each coordinate is multiplied by; wrapping: the index of the angle, if any.
    NearestNeighbours(std::span<const double> scales, std::optional<std::size_t> wrapping);

    std::size_t dimension() const { return scales_.size(); }
    std::size_t size() const { return size_; }
    void add(std::span<const double> row);
    /// The index of the nearest row, the first one of several. Precondition: size() > 0.
    std::size_t nearest(std::span<const double> row) const;

  private:
    static constexpr std::size_t lanes = 16;

    std::vector<double> scales_;
    std::optional<std::size_t> wrapping_;
    std::size_t size_ = 0;
    std::vector<float> blocks_;  ///< blocks of `lanes` rows, coordinate by coordinate
    mutable std::vector<float> query_;
};

}  // namespace asv::core
