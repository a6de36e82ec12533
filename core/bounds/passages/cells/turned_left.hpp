#pragma once

#include "core/model/problem.hpp"

namespace asv::core {

/// A problem whose chain turns left at the start: the problem that it was made of, or that with x
/// and y exchanged.
struct TurnedLeft {
    Problem problem;
    bool transposed = false;

    /// From one problem to the other, and back.
    Box back(const Box& box) const { return transposed ? geometry::transposed(box) : box; }
};

TurnedLeft turned_left(Problem problem);

}  // namespace asv::core
