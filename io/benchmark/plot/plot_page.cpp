#include "io/benchmark/plot/plot_page.hpp"

#include <span>

#include "io/benchmark/wording.hpp"

namespace asv::io {

namespace {

using geometry::Box;
using geometry::Point;
using geometry::Segment;

void grid_line(Canvas& canvas, const Palette& colours, const Point& a, const Point& b) {
    const Segment line{a, b};
    canvas.stroke_segments(std::span(&line, 1), {colours.grid, 1});
}

}  // namespace

void draw_header(Canvas& canvas, const Palette& colours, const BenchmarkReport& report,
                 const std::string& title) {
    canvas.text({page_left, 38}, title, {colours.ink, 20, true});
    canvas.text({page_left, 62},
                plan_facts(report.plan) + (report.complete() ? "" : "; interrupted"),
                {colours.muted, text_size});
    canvas.text({page_left, 82},
                "1 u = " + short_number(1000 * report.session.unit()) +
                    " ms, the time of 10\u2076 scalar state checks of 7 ASVs on this machine",
                {colours.muted, text_size});
    if (const std::string spoilt = spoilt_note(report.plan); !spoilt.empty())
        canvas.text({page_left, 100}, spoilt, {colours.violation, text_size});
}

void draw_panel_title(Canvas& canvas, const Palette& colours, const std::string& title,
                      const std::string& facts, double top) {
    const TextStyle style{colours.ink, 15, true};
    canvas.text({page_left, top + 20}, title, style);
    canvas.text({page_left + canvas.text_width(title, style) + 12, top + 20}, facts,
                {colours.muted, text_size});
}

void draw_upright_ticks(Canvas& canvas, const Palette& colours, const Box& field, const Axis& axis,
                        const std::vector<Tick>& ticks) {
    for (const Tick& tick : ticks) {
        const double x = axis.at(tick.value);
        grid_line(canvas, colours, {x, field.low.y}, {x, field.high.y});
        canvas.text({x, field.high.y + 17}, tick.label,
                    {colours.muted, tick_size, false, Align::centre});
    }
}

void draw_level_ticks(Canvas& canvas, const Palette& colours, const Box& field, const Axis& axis,
                      const std::vector<Tick>& ticks) {
    for (const Tick& tick : ticks) {
        const double y = axis.at(tick.value);
        grid_line(canvas, colours, {field.low.x, y}, {field.high.x, y});
        if (tick.label.empty()) continue;
        canvas.text({field.low.x - 8, y + 4}, tick.label,
                    {colours.muted, tick_size, false, Align::right});
    }
}

std::string shortened(Canvas& canvas, std::string text, const TextStyle& style, double width) {
    if (canvas.text_width(text, style) <= width) return text;
    while (!text.empty() && canvas.text_width(text + "\u2026", style) > width) {
        // A letter of UTF-8 may have several bytes.
        while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U)
            text.pop_back();
        if (!text.empty()) text.pop_back();
    }
    return text + "\u2026";
}

}  // namespace asv::io
