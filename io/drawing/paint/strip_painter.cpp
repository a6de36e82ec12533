#include "io/drawing/paint/strip_painter.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "io/drawing/paint/field_painter.hpp"
#include "io/drawing/paint/legend.hpp"
#include "io/drawing/scene/simplified_line.hpp"

namespace asv::io {

namespace {

using geometry::Box;
using geometry::Point;
using geometry::Segment;

constexpr double caption_height = 50;
constexpr double inset_radius = 84;
constexpr double plot_height = 92;

/// The legend leaves room for the inset where there is one.
double legend_width(const Scene& scene) {
    return Page::field_side - (scene.least ? 2 * inset_radius + 24 : 0);
}

/// Clearances stretch over orders of magnitude, and the small ones matter: a root scale.
double root_scale(double value, double most) {
    return std::sqrt(value / most);
}

/// 0 and the numbers 1, 2, 5 times powers of ten up to most that stand apart on a root scale.
std::vector<double> round_numbers(double most, double height) {
    constexpr double apart = 20;
    std::vector<double> result;
    double last = height + apart;
    for (double power = std::pow(10, std::ceil(std::log10(most))); power > most * 1e-4;
         power /= 10) {
        for (const double value : {power, power / 2, power / 5}) {
            const double y = root_scale(value, most) * height;
            if (value > most || y > last - apart || y < apart) continue;
            result.push_back(value);
            last = y;
        }
    }
    result.push_back(0);
    return result;
}

std::string shortest(double value) {
    std::ostringstream out;
    out << value;
    return out.str();
}

void paint_clearance_plot(Canvas& canvas, const Exhibit& exhibit, const Box& place,
                          const Palette& colours) {
    const auto& measures = exhibit.measures;
    double most = 0;
    for (const StateMeasures& m : measures) most = std::max(most, m.clearance->distance);
    if (most == 0) most = link_length(exhibit.problem);
    const double total = std::max(measures.back().cost, 1e-300);
    const auto at = [&](const StateMeasures& m) {
        return Point{
            place.low.x + m.cost / total * (place.high.x - place.low.x),
            place.high.y - root_scale(m.clearance->distance, most) * (place.high.y - place.low.y)};
    };
    canvas.fill_boxes(std::span(&place, 1), colours.field);
    const TextStyle label{colours.muted, Page::tick_size, false, Align::right};
    for (const double value : round_numbers(most, place.high.y - place.low.y)) {
        const double y = place.high.y - root_scale(value, most) * (place.high.y - place.low.y);
        const Segment line{{place.low.x, y}, {place.high.x, y}};
        canvas.stroke_segments(std::span(&line, 1), {colours.grid, 1});
        canvas.text({place.low.x - 6, y + 4}, shortest(value), label);
    }
    std::vector<Point> curve;
    curve.reserve(measures.size());
    for (const StateMeasures& m : measures) curve.push_back(at(m));
    curve = simplified(curve, 0.1);
    std::vector<Point> area = curve;
    area.push_back({curve.back().x, place.high.y});
    area.push_back({curve.front().x, place.high.y});
    canvas.fill_polygon(area, faded(colours.least, 0.18));
    canvas.stroke_line(curve, {colours.least, 1.4});
    const Point least = at(measures[*exhibit.tightest_state]);
    canvas.fill_circle(least, 6, colours.field);
    canvas.stroke_circle(least, 5, {colours.least, 2.2});
}

/// The page that shows the place where the clearance is least, so large that one sees the gap.
Page enlarged(const Page& page, const SceneLeast& least, const Point& centre, double broom) {
    const double gap =
        least.clearance == 0 ? broom / 20 : std::clamp(least.clearance, broom / 1e5, broom);
    const Point middle{(least.link.a.x + least.link.b.x) / 2,
                       (least.link.a.y + least.link.b.y) / 2};
    Page inset = page;
    // The gap takes a tenth of the circle; where there is none, a twentieth of a broom does.
    inset.scale = inset_radius / 5 / gap;
    const Point spot = inset.at(middle);
    inset.field.low.x += centre.x - spot.x;
    inset.field.high.y += centre.y - spot.y;
    return inset;
}

void paint_inset(Canvas& canvas, const Exhibit& exhibit, const Scene& scene, const Page& page,
                 const Point& centre, const Palette& colours) {
    const SceneLeast& least = *scene.least;
    const Page inset = enlarged(page, least, centre, link_length(exhibit.problem));
    canvas.push_clip_circle(centre, inset_radius);
    const Box all{{centre.x - inset_radius, centre.y - inset_radius},
                  {centre.x + inset_radius, centre.y + inset_radius}};
    canvas.fill_boxes(std::span(&all, 1), colours.field);
    std::vector<Box> boxes;
    for (const Box& obstacle : scene.obstacles) {
        const Box box = inset.at(obstacle);
        const bool seen = box.low.x < all.high.x && box.high.x > all.low.x &&
                          box.low.y < all.high.y && box.high.y > all.low.y;
        if (seen) boxes.push_back(box);
    }
    canvas.fill_boxes(boxes, colours.obstacle);
    const auto state = exhibit.solution->path.state(least.state);
    const double progress =
        exhibit.measures[least.state].cost / std::max(exhibit.measures.back().cost, 1e-300);
    paint_chain(canvas, inset.at(std::vector<Point>(state.begin(), state.end())), {2.5, 4},
                along_the_way(colours, progress));
    const Segment link = inset.at(least.link);
    canvas.stroke_segments(std::span(&link, 1), {colours.least, 3});
    canvas.pop_clip();
    canvas.stroke_circle(centre, inset_radius, {colours.least, 2.4});
}

/// "broom 3, ", or nothing for a point.
std::string which_link(core::BodyKind body, const Clearance& clearance) {
    const std::string link = words_for(body).link;
    return link.empty() ? "" : link + " " + std::to_string(clearance.broom + 1) + ", ";
}

void paint_caption(Canvas& canvas, const Exhibit& exhibit, const SceneLeast& least, const Point& at,
                   double zoom, const Palette& colours) {
    const Clearance& clearance = *exhibit.measures[least.state].clearance;
    canvas.text(at,
                "least clearance " + (least.clearance == 0
                                          ? "0: it collides"
                                          : with_unit(fixed(least.clearance, 6), exhibit.unit)),
                {colours.ink, Page::text_size, true, Align::left});
    canvas.text({at.x, at.y + 17},
                which_link(exhibit.problem.body_kind(), clearance) + "obstacle " +
                    std::to_string(clearance.obstacle + 1) + ", step " + grouped(least.state) +
                    ", enlarged " + fixed(zoom, 0) + " times",
                {colours.muted, Page::text_size, false, Align::left});
}

}  // namespace

double strip_height(const Exhibit& exhibit, const Scene& scene) {
    // Text is a little wider in some formats than in others: rather a line too many.
    Canvas ruler(PictureFormat::png, 1, 1, 1);
    const double lines =
        legend_height(ruler, legend(scene, palette(Theme::light)), 0.97 * legend_width(scene));
    return lines + (exhibit.tightest_state ? caption_height + plot_height + 8 : 0);
}

void paint_strip(Canvas& canvas, const Exhibit& exhibit, const Scene& scene, const Page& page,
                 const Palette& colours) {
    paint_legend(canvas, legend(scene, colours), {Page::left, page.strip_top + 12},
                 legend_width(scene), colours);
    if (!scene.least) return;
    const double bottom = page.strip_top + strip_height(exhibit, scene) - 8;
    const Box plot{{Page::left, bottom - plot_height}, {Page::left + legend_width(scene), bottom}};
    const Point centre{page.width - Page::right - inset_radius - 2, bottom - inset_radius - 2};
    const Page inset = enlarged(page, *scene.least, centre, link_length(exhibit.problem));
    paint_caption(canvas, exhibit, *scene.least, {plot.low.x, plot.low.y - 25},
                  inset.scale / page.scale, colours);
    canvas.text({plot.high.x, plot.low.y - 8}, "clearance along the way",
                {colours.muted, Page::text_size, false, Align::right});
    paint_clearance_plot(canvas, exhibit, plot, colours);
    paint_inset(canvas, exhibit, scene, page, centre, colours);
}

}  // namespace asv::io
