#include "io/drawing/paint/legend.hpp"

#include <algorithm>
#include <array>

#include "io/drawing/paint/field_painter.hpp"

namespace asv::io {

using geometry::Point;

namespace {

constexpr double line_height = 24;
constexpr double gap = 4;  ///< between the drawing of an entry and its words
constexpr double bar_width = 120;
constexpr double bar_height = 10;

void add_line_entry(std::vector<LegendEntry>& entries, std::string words, Stroke stroke,
                    double dot) {
    entries.push_back(
        {std::move(words), [stroke, dot](Canvas& canvas, const Point& at) {
             const std::array<Point, 2> ends{Point{at.x + 3, at.y}, Point{at.x + 27, at.y}};
             canvas.stroke_line(ends, stroke);
             if (dot == 0) return;
             for (const Point& end : ends) {
                 canvas.fill_circle(end, dot, stroke.colour);
             }
         }});
}

/// The colours from start to goal, side by side.
LegendEntry colour_bar(const Palette& colours) {
    return {"share of the cost, from start to goal",
            [&colours](Canvas& canvas, const Point& at) {
                constexpr int parts = 24;
                for (int i = 0; i < parts; ++i) {
                    const double from = static_cast<double>(i) / parts;
                    // Each part runs under all that follow: no gap shows between two.
                    const geometry::Box part{{at.x + from * bar_width, at.y - bar_height / 2},
                                             {at.x + bar_width, at.y + bar_height / 2}};
                    canvas.fill_boxes(std::span(&part, 1),
                                      along_the_way(colours, from + 0.5 / parts));
                }
            },
            bar_width + gap};
}

/// Of what stands alone in the field.
void add_marks(std::vector<LegendEntry>& entries, const Scene& scene, const Palette& colours) {
    if (scene.least) {
        entries.push_back(
            {"least clearance, and where it is tight", [&colours](Canvas& canvas, const Point& at) {
                 const Point centre{at.x + 15, at.y};
                 canvas.fill_circle(centre, 4, faded(colours.least, 0.5));
                 canvas.stroke_circle(centre, 8, {colours.least, 2.2});
             }});
    }
    if (!scene.closed.empty()) {
        entries.push_back(
            {scene.meaning_of_closed, [&colours](Canvas& canvas, const Point& at) {
                 const geometry::Box sample{{at.x + 5, at.y - 6}, {at.x + 25, at.y + 6}};
                 paint_closed(canvas, std::span(&sample, 1), colours);
             }});
    }
    if (!scene.violations.empty()) {
        entries.push_back({"violated requirement", [&colours](Canvas& canvas, const Point& at) {
                               paint_violation_mark(canvas, {at.x + 15, at.y}, colours);
                           }});
    }
}

/// The left end of each entry, set line by line from the origin, and the height of all lines.
struct LegendLayout {
    std::vector<Point> places;
    double height = 0;
};

LegendLayout lay_out(Canvas& canvas, const std::vector<LegendEntry>& entries, double width) {
    LegendLayout layout;
    Point at{0, 0};
    for (const LegendEntry& entry : entries) {
        const double needed =
            entry.width + gap + canvas.text_width(entry.words, {{}, Page::text_size});
        if (at.x > 0 && at.x + needed > width) at = {0, at.y + line_height};
        layout.places.push_back(at);
        at.x += needed + 20;
    }
    layout.height = at.y + line_height;
    return layout;
}

}  // namespace

std::vector<LegendEntry> legend(const Scene& scene, const Palette& colours) {
    std::vector<LegendEntry> entries;
    const Colour middle = along_the_way(colours, 0.5);
    const BodyWords words = words_for(scene.body);
    const std::string eye = words.first.empty() ? "" : " (" + words.first + ")";
    add_line_entry(entries, "start" + eye, {colours.start, 3}, 4);
    add_line_entry(entries, "goal", {colours.goal, 3}, 4);
    if (scene.ghosts > 0) {
        add_line_entry(entries,
                       words.chain + " on its way, evenly in " +
                           (scene.body == core::BodyKind::arm ? "cost" : "distance"),
                       {middle, 1.5}, 1.8);
    }
    const auto has = [&](Role role) {
        return std::any_of(scene.lines.begin(), scene.lines.end(),
                           [&](const SceneLine& line) { return line.role == role; });
    };
    if (has(Role::path)) {
        const bool first = !scene.trees.empty();
        add_line_entry(entries, first ? words.seen_path : words.path, path_stroke(scene, middle),
                       0);
    }
    if (scene.ghosts > 0 || has(Role::path)) entries.push_back(colour_bar(colours));
    if (has(Role::start_closing)) {
        add_line_entry(entries, "closing side", {faded(middle, 0.75), 1.2, {3, 4}}, 0);
    }
    for (const SceneTree& tree : scene.trees) {
        const bool start = tree.kind == SceneTree::Kind::start;
        const bool roadmap = tree.kind == SceneTree::Kind::roadmap;
        const Colour colour = roadmap ? colours.least : start ? colours.start : colours.goal;
        const std::string what = roadmap ? "roadmap" : start ? "start tree" : "goal tree";
        add_line_entry(entries, what + " (" + words.seen + ")", {faded(colour, 0.6), 0.9}, 0);
    }
    add_marks(entries, scene, colours);
    return entries;
}

double legend_height(Canvas& canvas, const std::vector<LegendEntry>& entries, double width) {
    return lay_out(canvas, entries, width).height;
}

void paint_legend(Canvas& canvas, const std::vector<LegendEntry>& entries, const Point& corner,
                  double width, const Palette& colours) {
    const LegendLayout layout = lay_out(canvas, entries, width);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const Point at{corner.x + layout.places[i].x, corner.y + layout.places[i].y};
        entries[i].draw(canvas, at);
        canvas.text({at.x + entries[i].width + gap, at.y + 4.5}, entries[i].words,
                    {colours.ink, Page::text_size});
    }
}

}  // namespace asv::io
