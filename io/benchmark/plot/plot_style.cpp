#include "io/benchmark/plot/plot_style.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace asv::io {

namespace {

using geometry::Point;

constexpr std::array<Colour, 8> light_colours{rgb(0x0068A8), rgb(0xC24E00), rgb(0x007D57),
                                              rgb(0xA03A7C), rgb(0x8A6500), rgb(0x2B8CC4),
                                              rgb(0x18242F), rgb(0x76828E)};
constexpr std::array<Colour, 8> dark_colours{rgb(0x56B4E9), rgb(0xFF8A4C), rgb(0x35C99B),
                                             rgb(0xE08FC0), rgb(0xE3B53A), rgb(0xA9C8FF),
                                             rgb(0xE8EEF4), rgb(0x8C9CAC)};

/// Corners on a circle, the first one straight up turned by the given share of a round.
std::vector<Point> regular(std::size_t corners, double turned) {
    std::vector<Point> outline;
    for (std::size_t k = 0; k < corners; ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(corners) + turned;
        const double angle = 2 * std::numbers::pi * share;
        outline.push_back({std::sin(angle), -std::cos(angle)});
    }
    return outline;
}

/// A plus of arms 0.7 wide, turned by the given angle.
std::vector<Point> cross(double angle) {
    constexpr double a = 0.35, b = 1.05;
    std::vector<Point> outline{{a, -b}, {a, -a}, {b, -a}, {b, a},   {a, a},   {a, b},
                               {-a, b}, {-a, a}, {-b, a}, {-b, -a}, {-a, -a}, {-a, -b}};
    for (Point& point : outline)
        point = {point.x * std::cos(angle) - point.y * std::sin(angle),
                 point.x * std::sin(angle) + point.y * std::cos(angle)};
    return outline;
}

/// The marks that are no discs, of radius about 1.
const std::array<std::vector<Point>, 6>& outlines() {
    static const std::array<std::vector<Point>, 6> all{
        regular(4, 0.125), regular(3, 0), regular(4, 0),
        regular(3, 0.5),   cross(0),      cross(std::numbers::pi / 4)};
    return all;
}

}  // namespace

Colour planner_colour(std::size_t planner, Theme theme) {
    const auto& colours = theme == Theme::light ? light_colours : dark_colours;
    return colours[planner % colours.size()];
}

void draw_mark(Canvas& canvas, std::size_t planner, const Point& at, double radius,
               const Colour& colour, bool hollow, const Colour& page) {
    const Colour& inside = hollow ? page : colour;
    const std::size_t shape = planner % (outlines().size() + 1);
    if (shape == 0) {
        canvas.fill_circle(at, radius, inside);
        if (hollow) canvas.stroke_circle(at, radius, {colour, 1.2});
        return;
    }
    // So much larger that all marks have about one area.
    const double size = 1.2 * radius;
    std::vector<Point> outline = outlines()[shape - 1];
    for (Point& point : outline) point = {at.x + size * point.x, at.y + size * point.y};
    canvas.fill_polygon(outline, inside);
    if (!hollow) return;
    outline.push_back(outline.front());
    canvas.stroke_line(outline, {colour, 1.2});
}

}  // namespace asv::io
