#pragma once

#include <cstddef>
#include <vector>

#include "geometry/primitives.hpp"

namespace asv::io {

/// Where things stand on the page of a picture, in points from the upper left.
struct Page {
    static constexpr double field_side = 800;  ///< the longer side of the field, always
    static constexpr double left = 52;         ///< room for the numbers of the axis
    static constexpr double right = 28;
    static constexpr double line_height = 22;
    // Few sizes: an svg carries the letters of each.
    static constexpr double text_size = 13.5;
    static constexpr double tick_size = 11.5;  ///< of the numbers beside the axes

    double width = 0;
    double height = 0;
    double scale = 1;      ///< points for one workspace unit
    geometry::Box world;   ///< the field in workspace units
    geometry::Box field;   ///< the field on the page
    double strip_top = 0;  ///< of what is below the field

    Page() = default;
    /// Precondition: world is not empty and has an extent in both coordinates.
    /// strip_height is what the legend, the plot and the inset below the field need.
    Page(const geometry::Box& world, std::size_t header_lines, double strip_height);

    /// A page that is the field alone, its longer side as long as given.
    static Page of_field(const geometry::Box& world, double side);

    geometry::Point at(const geometry::Point& point) const;
    geometry::Box at(const geometry::Box& box) const;
    geometry::Segment at(const geometry::Segment& segment) const;
    std::vector<geometry::Point> at(const std::vector<geometry::Point>& points) const;
};

}  // namespace asv::io
