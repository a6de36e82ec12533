#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/primitives.hpp"

namespace asv::core {

/// The states of a chain one after the other, from the start to the goal: one row of asv_count
/// positions each, ASV 1 first, all in one block.
class Path {
  public:
    explicit Path(std::size_t asv_count) : asv_count_(asv_count) {}

    std::size_t asv_count() const { return asv_count_; }
    std::size_t size() const { return asv_count_ == 0 ? 0 : points_.size() / asv_count_; }
    bool empty() const { return points_.empty(); }

    std::span<const geometry::Point> state(std::size_t i) const {
        return {points_.data() + i * asv_count_, asv_count_};
    }
    std::span<const geometry::Point> points() const { return points_; }

    /// Appends one state. Precondition: state.size() == asv_count().
    void push_back(std::span<const geometry::Point> state) {
        points_.insert(points_.end(), state.begin(), state.end());
    }
    void reserve(std::size_t states) { points_.reserve(states * asv_count_); }

    friend bool operator==(const Path&, const Path&) = default;

  private:
    std::size_t asv_count_;
    std::vector<geometry::Point> points_;
};

/// What a solution file says: the states and the total cost that its first line claims.
/// A path of size k + 1 has k primitive steps.
struct Solution {
    Path path;
    double cost = 0;
};

}  // namespace asv::core
