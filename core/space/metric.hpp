#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/chain/chain.hpp"
#include "geometry/primitives.hpp"

namespace asv::core {

/// A diagonal metric of C-space that means motion: a displacement of length s moves the ASVs by
/// about s (root mean square), averaged over some reference shapes. Coordinates times scale() are
/// Euclidean, which is what the trees and the constrained steps work in.
class Metric {
  public:
    /// Precondition: chain is anchored at its centroid, each shape has asv_count() positions.
    Metric(const Chain& chain, std::span<const std::vector<geometry::Point>> shapes);

    std::size_t dimension() const { return scale_.size(); }
    /// Length of a unit displacement of coordinate i.
    double scale(std::size_t i) const { return scale_[i]; }
    std::span<const double> scales() const { return scale_; }

    /// Distance between two rows whose headings are unwrapped alike.
    double distance(std::span<const double> a, std::span<const double> b) const;

  private:
    std::vector<double> scale_;
};

}  // namespace asv::core
