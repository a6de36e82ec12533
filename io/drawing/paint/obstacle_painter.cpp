#include "io/drawing/paint/obstacle_painter.hpp"

#include <algorithm>

#include "io/drawing/scene/box_union.hpp"

namespace asv::io {

namespace {

using geometry::Box;
using geometry::Point;
using geometry::Segment;

/// The numbers of more would be a crowd that nobody looks one up in.
constexpr std::size_t max_numbered_obstacles = 50;
/// More than these become pixels in formats of lines too.
constexpr std::size_t max_drawn_obstacles = 20'000;
/// As many boxes at a time are moved to the page: a multiple of what Canvas puts into one path.
constexpr std::size_t boxes_at_a_time = 4096;
constexpr double outline_width = 0.8;
/// Wide enough to close the gap that smoothing leaves between two boxes side by side.
constexpr double seam_width = 0.6;

/// Calls paint with the boxes on the page, part by part.
template <class Paint>
void for_boxes_on_page(const Scene& scene, const Page& page, const Paint& paint) {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
        boxes.push_back(page.at(scene.obstacles[i]));
        if (boxes.size() < boxes_at_a_time && i + 1 < scene.obstacles.size()) continue;
        paint(std::span<const Box>(boxes));
        boxes.clear();
    }
}

std::vector<Segment> on_page(const std::vector<Segment>& segments, const Page& page) {
    std::vector<Segment> result;
    result.reserve(segments.size());
    for (const Segment& segment : segments) result.push_back(page.at(segment));
    return result;
}

void paint_as_pixels(Canvas& canvas, const Scene& scene, const Page& page, const Colour& colour) {
    canvas.push_pixels(page.field);
    for_boxes_on_page(scene, page, [&](std::span<const Box> boxes) {
        canvas.fill_boxes(boxes, colour);
        canvas.stroke_boxes(boxes, {colour, seam_width});
    });
    canvas.pop_pixels();
}

/// Where the number of an obstacle stands on the page.
Box number_place(Canvas& canvas, const Box& box, const std::string& number,
                 const TextStyle& style) {
    const Point middle = geometry::centre(box);
    const double half_width = canvas.text_width(number, style) / 2 + 2;
    const double half_height = 8;
    return {{middle.x - half_width, middle.y - half_height},
            {middle.x + half_width, middle.y + half_height}};
}

}  // namespace

void paint_obstacles(Canvas& canvas, const Scene& scene, const Page& page, const Palette& colours) {
    if (scene.obstacles.size() > max_drawn_obstacles) {
        paint_as_pixels(canvas, scene, page, colours.obstacle);
        return;
    }
    for_boxes_on_page(scene, page, [&](std::span<const Box> boxes) {
        canvas.fill_boxes(boxes, colours.obstacle);
    });
    const UnionSides sides = union_sides(scene.obstacles);
    canvas.stroke_segments(on_page(sides.seams, page), {colours.obstacle, seam_width});
    canvas.stroke_segments(on_page(sides.outline, page),
                           {mixed(colours.obstacle, colours.ink, 0.35), outline_width});
}

void paint_obstacle_numbers(Canvas& canvas, const Scene& scene, const Page& page,
                            const Palette& colours) {
    if (scene.obstacles.size() > max_numbered_obstacles) return;
    const TextStyle style{colours.ink, Page::text_size, true, Align::centre};
    for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
        const Box box = page.at(scene.obstacles[i]);
        const std::string number = std::to_string(i + 1);
        const Box place = number_place(canvas, box, number, style);
        const auto touches = [&](const Box& other) {
            return &other != &scene.obstacles[i] && geometry::overlap(page.at(other), place);
        };
        const bool fits = geometry::contains(box, place.low) && geometry::contains(box, place.high);
        if (!fits || std::any_of(scene.obstacles.begin(), scene.obstacles.end(), touches)) continue;
        canvas.text({(place.low.x + place.high.x) / 2, place.high.y - 4}, number, style);
    }
}

}  // namespace asv::io
