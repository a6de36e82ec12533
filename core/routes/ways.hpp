#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/model/problem.hpp"

namespace asv::core {

/// A class of ways through the plane: all that use none of the closed gates.
struct Way {
    std::vector<Box> closed;  ///< boxes in the place of gates, none of which meets start or goal
    /// What every ASV alone would need at least, summed up: an estimate of what a path of the class
    /// costs at least, since an ASV may swing into a gate and back.
    double bound = 0;
    /// Of the shortest way of the class for the ASV in the middle of the chain.
    std::vector<Point> bends = {};
    std::vector<Box> kept_open = {};  ///< by the classes that are made of this one
};

/// The problem with boxes in the place of the closed gates.
Problem with_closed_gates(Problem problem, const std::vector<Box>& closed);

/// The classes of ways of a problem in the order of their bounds. The first has no gate closed;
/// others are made of one by closing a gate of its shortest way, and keeping open those that came
/// before it, so that none is made twice (ranking by exclusion: Lawler, 1972).
class Ways {
  public:
    /// The problem is that of a chain with bounds, valid ends, and outlives this.
    explicit Ways(const Problem& problem);

    /// The next class; none when there are no more. Among very many boxes there is one class only,
    /// and its bound is 0.
    std::optional<Way> next();

    /// Microseconds that all of that has taken, counted.
    double work() const { return work_; }

  private:
    void make_others_of(const Way& way);
    void add(Way way);

    const Problem& problem_;
    std::vector<Way> waiting_;
    std::optional<Way> last_;  ///< given, but no others made of it yet
    double work_ = 0;
};

}  // namespace asv::core
