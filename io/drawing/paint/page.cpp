#include "io/drawing/paint/page.hpp"

#include <algorithm>

namespace asv::io {

using geometry::Box;
using geometry::Point;
using geometry::Segment;

namespace {

constexpr double header_top = 56;   ///< base line of the facts, below the title
constexpr double header_gap = 18;   ///< between the last line and the field
constexpr double axis_height = 40;  ///< numbers below the field, and a gap

}  // namespace

Page::Page(const Box& the_world, std::size_t header_lines, double strip_height) : world(the_world) {
    const double across = world.high.x - world.low.x;
    const double up = world.high.y - world.low.y;
    scale = field_side / std::max(across, up);
    const double top = header_top + line_height * static_cast<double>(header_lines) + header_gap;
    // A narrow field is centred: the header needs the whole width in any case.
    const double indent = (field_side - scale * across) / 2;
    field = {{left + indent, top}, {left + indent + scale * across, top + scale * up}};
    width = left + field_side + right;
    strip_top = field.high.y + axis_height;
    height = strip_top + strip_height + right;
}

Page Page::of_field(const Box& world, double side) {
    const double across = world.high.x - world.low.x;
    const double up = world.high.y - world.low.y;
    Page page;
    page.world = world;
    page.scale = side / std::max(across, up);
    page.width = page.scale * across;
    page.height = page.scale * up;
    page.field = {{0, 0}, {page.width, page.height}};
    return page;
}

Point Page::at(const Point& point) const {
    return {field.low.x + (point.x - world.low.x) * scale,
            field.high.y - (point.y - world.low.y) * scale};
}

Box Page::at(const Box& box) const {
    const Point low = at(box.low);
    const Point high = at(box.high);
    return {{low.x, high.y}, {high.x, low.y}};
}

Segment Page::at(const Segment& segment) const {
    return {at(segment.a), at(segment.b)};
}

std::vector<Point> Page::at(const std::vector<Point>& points) const {
    std::vector<Point> result;
    result.reserve(points.size());
    for (const Point& point : points) result.push_back(at(point));
    return result;
}

}  // namespace asv::io
