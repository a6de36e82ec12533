#include "io/drawing/paint/field_painter.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/drawing/paint/obstacle_painter.hpp"

namespace asv::io {

namespace {

using geometry::Box;
using geometry::Point;
using geometry::Segment;

constexpr double end_broom = 3;
constexpr double end_dot = 4;
constexpr double label_size = 15;
constexpr double min_radius = 13;

/// 1, 2 or 5 times a power of ten, so that about five of them fit into the extent.
double tick_step(double extent) {
    const double power = std::pow(10, std::floor(std::log10(extent / 4)));
    const double rest = extent / 4 / power;
    return power * (rest >= 5 ? 5 : rest >= 2 ? 2 : 1);
}

int digits_of(double step) {
    return std::max(0, static_cast<int>(std::ceil(-std::log10(step))));
}

std::vector<double> ticks(double low, double high) {
    const double step = tick_step(high - low);
    std::vector<double> result;
    for (double k = std::ceil(low / step); k * step <= high + step * 1e-9; ++k) {
        result.push_back(k * step + 0.0);  // no "-0"
    }
    return result;
}

void paint_grid(Canvas& canvas, const Page& page, const Palette& colours) {
    const Stroke line{colours.grid, 1};
    const TextStyle below{colours.muted, Page::tick_size, false, Align::centre};
    const TextStyle beside{colours.muted, Page::tick_size, false, Align::right};
    const Box& world = page.world;
    const int digits =
        digits_of(tick_step(std::max(world.high.x - world.low.x, world.high.y - world.low.y)));
    for (const double x : ticks(world.low.x, world.high.x)) {
        const Segment across = page.at(Segment{{x, world.low.y}, {x, world.high.y}});
        canvas.stroke_segments(std::span(&across, 1), line);
        canvas.text({across.a.x, page.field.high.y + 17}, fixed(x, digits), below);
    }
    for (const double y : ticks(world.low.y, world.high.y)) {
        const Segment up = page.at(Segment{{world.low.x, y}, {world.high.x, y}});
        canvas.stroke_segments(std::span(&up, 1), line);
        canvas.text({page.field.low.x - 8, up.a.y + 4}, fixed(y, digits), beside);
    }
}

void paint_trees(Canvas& canvas, const Scene& scene, const Page& page, const Palette& colours) {
    for (const SceneTree& tree : scene.trees) {
        const Colour colour = tree.kind == SceneTree::Kind::start  ? colours.start
                              : tree.kind == SceneTree::Kind::goal ? colours.goal
                                                                   : colours.least;
        std::vector<Segment> edges;
        for (const Segment& edge : tree.edges) edges.push_back(page.at(edge));
        canvas.stroke_segments(edges, {faded(colour, 0.5), 0.8});
        canvas.fill_dots(page.at(tree.nodes), 1.2, faded(colour, 0.8));
        for (const Point& root : tree.roots) canvas.fill_circle(page.at(root), 3, colour);
    }
}

void paint_line(Canvas& canvas, const Scene& scene, const SceneLine& line, const Page& page,
                const Palette& colours) {
    const std::vector<Point> points = page.at(line.points);
    const Colour colour = along_the_way(colours, line.progress);
    switch (line.role) {
        case Role::path:
            canvas.stroke_line(points, path_stroke(scene, colour));
            break;
        case Role::ghost_closing:
            canvas.stroke_line(points, {faded(colour, 0.4), 0.8, {2, 3}});
            break;
        case Role::ghost:
            paint_chain(canvas, points, {1.5, 1.8}, colour);
            break;
        case Role::start_closing:
        case Role::goal_closing:
            canvas.stroke_line(points, {faded(colour, 0.75), 1.4, {3, 4}});
            break;
        case Role::start:
        case Role::goal:
            paint_body(canvas, points, colours, colour);
            break;
        case Role::violation:
            paint_chain(canvas, points, {2.2, 2.6}, colours.violation);
            break;
    }
}

void paint_least(Canvas& canvas, const SceneLeast& least, const Page& page,
                 const Palette& colours) {
    std::vector<Point> walls;
    for (const Segment& link : least.links) walls.push_back(page.at(link.b));
    canvas.fill_dots(walls, 4, faded(colours.least, 0.5));
    const Segment link = page.at(least.link);
    const Point middle{(link.a.x + link.b.x) / 2, (link.a.y + link.b.y) / 2};
    canvas.stroke_circle(middle, min_radius, {colours.field, 5});
    canvas.stroke_circle(middle, min_radius, {colours.least, 2.4});
}

void paint_violations(Canvas& canvas, const Scene& scene, const Page& page,
                      const Palette& colours) {
    for (const SceneViolation& violation : scene.violations) {
        paint_violation_mark(canvas, page.at(violation.at), colours);
    }
}

/// Where the label hides least: below, above, right or left of the chain, inside the field.
Box label_place(const Box& chain, double width, const Scene& scene, const Page& page) {
    const double height = label_size + 6;
    const double gap = end_dot + 5;
    const Point middle = geometry::centre(chain);
    const auto box = [&](double x, double y) { return Box{{x, y}, {x + width, y + height}}; };
    const std::array<Box, 4> places{box(middle.x - width / 2, chain.high.y + gap),
                                    box(middle.x - width / 2, chain.low.y - gap - height),
                                    box(chain.high.x + gap, middle.y - height / 2),
                                    box(chain.low.x - gap - width, middle.y - height / 2)};
    const auto hidden = [&](const Box& place) {
        std::size_t count = 0;
        const bool inside = place.low.x >= page.field.low.x && place.high.x <= page.field.high.x &&
                            place.low.y >= page.field.low.y && place.high.y <= page.field.high.y;
        if (!inside) count += 1000000;
        for (const Box& obstacle : scene.obstacles) {
            if (geometry::overlap(place, page.at(obstacle))) count += 20;
        }
        for (const SceneLine& line : scene.lines) {
            if (line.role == Role::path) continue;
            for (const Point& point : line.points) {
                const Point on_page = page.at(point);
                if (geometry::overlap(place, Box{on_page, on_page})) ++count;
            }
        }
        return count;
    };
    return *std::min_element(places.begin(), places.end(),
                             [&](const Box& a, const Box& b) { return hidden(a) < hidden(b); });
}

void paint_labels(Canvas& canvas, const Scene& scene, const Page& page, const Palette& colours) {
    for (const SceneLine& line : scene.lines) {
        if (line.role != Role::start && line.role != Role::goal) continue;
        const bool start = line.role == Role::start;
        const TextStyle style{start ? colours.start : colours.goal, label_size, true,
                              Align::centre};
        const std::string word = start ? "start" : "goal";
        const double width = canvas.text_width(word, style) + 10;
        const Box place =
            label_place(geometry::bounding_box(page.at(line.points)), width, scene, page);
        canvas.fill_boxes(std::span(&place, 1), faded(colours.field, 0.85));
        canvas.text({(place.low.x + place.high.x) / 2, place.high.y - 6}, word, style);
    }
}

}  // namespace

Stroke path_stroke(const Scene& scene, const Colour& colour) {
    return scene.trees.empty() ? Stroke{faded(colour, 0.55), 0.9} : Stroke{colour, 2.4};
}

Colour along_the_way(const Palette& colours, double progress) {
    return mixed(colours.start, colours.goal, progress);
}

void paint_chain(Canvas& canvas, const std::vector<Point>& points, const Pen& pen,
                 const Colour& colour) {
    canvas.stroke_line(points, {colour, pen.broom});
    canvas.fill_dots(points, pen.dot, colour);
}

void paint_body(Canvas& canvas, const std::vector<Point>& points, const Palette& colours,
                const Colour& colour) {
    paint_chain(canvas, points, {end_broom + 3, end_dot + 1.5}, colours.field);
    paint_chain(canvas, points, {end_broom, end_dot}, colour);
    // ASV 1 is the one with an eye: the order of the chain shows.
    canvas.fill_circle(points.front(), end_dot / 2, colours.field);
}

void paint_violation_mark(Canvas& canvas, const Point& at, const Palette& colours) {
    constexpr double arm = 5;
    const std::array<Segment, 2> cross{Segment{{at.x - arm, at.y - arm}, {at.x + arm, at.y + arm}},
                                       Segment{{at.x - arm, at.y + arm}, {at.x + arm, at.y - arm}}};
    canvas.fill_circle(at, 10, faded(colours.field, 0.8));
    canvas.stroke_circle(at, 10, {colours.violation, 2.2});
    canvas.stroke_segments(cross, {colours.violation, 2.6});
}

void paint_closed(Canvas& canvas, std::span<const Box> closed, const Palette& colours) {
    canvas.fill_boxes(closed, faded(colours.violation, 0.25));
    canvas.stroke_boxes(closed, {colours.violation, 1.4, {4, 3}});
}

void paint_scene(Canvas& canvas, const Scene& scene, const Page& page, const Palette& colours) {
    paint_obstacles(canvas, scene, page, colours);
    std::vector<Box> closed;
    for (const Box& box : scene.closed) closed.push_back(page.at(box));
    paint_closed(canvas, closed, colours);
    paint_trees(canvas, scene, page, colours);
    for (const SceneLine& line : scene.lines) paint_line(canvas, scene, line, page, colours);
}

void paint_bare_field(Canvas& canvas, const Scene& scene, const Page& page,
                      const Palette& colours) {
    canvas.fill_boxes(std::span(&page.field, 1), colours.field);
    canvas.push_clip(page.field);
    paint_scene(canvas, scene, page, colours);
    paint_violations(canvas, scene, page, colours);
    canvas.pop_clip();
    canvas.stroke_boxes(std::span(&page.field, 1), {colours.muted, 1.2});
}

void paint_field(Canvas& canvas, const Scene& scene, const Page& page, const Palette& colours) {
    canvas.fill_boxes(std::span(&page.field, 1), colours.field);
    paint_grid(canvas, page, colours);
    canvas.push_clip(page.field);
    paint_scene(canvas, scene, page, colours);
    paint_obstacle_numbers(canvas, scene, page, colours);
    if (scene.least) paint_least(canvas, *scene.least, page, colours);
    paint_violations(canvas, scene, page, colours);
    paint_labels(canvas, scene, page, colours);
    canvas.pop_clip();
    canvas.stroke_boxes(std::span(&page.field, 1), {colours.muted, 1.2});
}

}  // namespace asv::io
