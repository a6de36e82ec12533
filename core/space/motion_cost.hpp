#pragma once

#include <span>

#include "core/chain/chain.hpp"
#include "core/search/search_result.hpp"

namespace asv::core {

/// What a straight line in C-space costs: the sum of the lengths of the curves that the ASVs draw,
/// by chords short enough to be right to about 0.1 %. Holds scratch memory.
class MotionCost {
  public:
    explicit MotionCost(const Chain& chain);

    double operator()(std::span<const double> from, std::span<const double> to);

    /// The cost of all motions of a path.
    double path(const Configurations& rows);

  private:
    const Chain& chain_;
    std::vector<double> row_, step_, heading_rate_;
    // Of all moments, one after the other:
    std::vector<geometry::Point> places_;
    std::vector<double> headings_, sines_, cosines_;
    std::vector<double> x_, y_, last_x_, last_y_;
};

}  // namespace asv::core
