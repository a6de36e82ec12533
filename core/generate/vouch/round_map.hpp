#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/model/problem.hpp"

namespace asv::core {

/// The places where a disc fits, on a square grid over the unit square, and which of them hang
/// together. A chain bent to a regular polygon stays inside such a disc, whatever its heading.
class RoundMap {
  public:
    /// A disc of this radius that is free of all boxes and inside the bounds, with a little to
    /// spare. Grid spacing: a tenth of the radius, so that ways one fifth wider than the disc count
    /// as open. Precondition: radius > 0. Cost: the grid's cells plus those that the grown boxes
    /// cover.
    RoundMap(const Problem& problem, double radius);

    static constexpr std::uint32_t none = 0xffffffff;

    double spacing() const { return spacing_; }
    Point place(std::uint32_t node) const;
    /// Nodes that hang together have one number.
    std::uint32_t component(std::uint32_t node) const { return component_[node]; }

    /// Up to `count` free nodes within the distance of a point, nearest first, thinned out evenly
    /// where there are more.
    std::vector<std::uint32_t> near(const Point& point, double distance, std::size_t count) const;

    /// The corners of a shortest way over the grid (steps to the four neighbours).
    /// Precondition: both nodes are of one component.
    std::vector<Point> route(std::uint32_t from, std::uint32_t to) const;

  private:
    void block(const Box& box, double radius);
    void label_components();
    template <class Visit>
    void visit_neighbours(std::uint32_t node, Visit&& visit) const;

    double spacing_;
    std::uint32_t side_;
    std::vector<bool> free_;
    std::vector<std::uint32_t> component_;
};

}  // namespace asv::core
