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

constexpr double warning_height = 20;

/// Why the picture is not to be taken as it is; empty where it may be.
std::string warning_of(const BenchmarkReport& report) {
    std::string text = spoilt_note(report.plan);
    if (!report.complete()) text += text.empty() ? "Interrupted." : " Interrupted.";
    return text;
}

}  // namespace

PageMeasures page_measures(PlotLayout layout) {
    if (layout == PlotLayout::column) return {360, 8, 54, 336};
    return {960, 64, 64, 924};
}

double header_height(const BenchmarkReport& report, PlotLayout layout) {
    if (layout == PlotLayout::wide) return greatest_header;
    return warning_of(report).empty() ? 0 : warning_height;
}

void draw_header(Canvas& canvas, const Palette& colours, const BenchmarkReport& report,
                 const std::string& title, PlotLayout layout) {
    const double left = page_measures(layout).words;
    if (layout == PlotLayout::column) {
        if (const std::string warning = warning_of(report); !warning.empty())
            canvas.text({left, 18}, warning, {colours.violation, tick_size});
        return;
    }
    canvas.text({left, 38}, title, {colours.ink, 20, true});
    canvas.text({left, 62}, plan_facts(report.plan) + (report.complete() ? "" : "; interrupted"),
                {colours.muted, text_size});
    canvas.text({left, 82},
                "1 u = " + short_number(1000 * report.session.unit()) +
                    " ms, the time of 10\u2076 scalar state checks of 7 ASVs on this machine",
                {colours.muted, text_size});
    if (const std::string spoilt = spoilt_note(report.plan); !spoilt.empty())
        canvas.text({left, 100}, spoilt, {colours.violation, text_size});
}

void draw_panel_title(Canvas& canvas, const Palette& colours, const std::string& title,
                      const std::string& facts, double top, PlotLayout layout) {
    const PageMeasures page = page_measures(layout);
    const TextStyle style{colours.ink, 15, true};
    const std::string shown = shortened(canvas, title, style, page.right - page.words);
    canvas.text({page.words, top + 20}, shown, style);
    if (layout == PlotLayout::column) return;
    const TextStyle small{colours.muted, text_size};
    const double facts_left = page.words + canvas.text_width(shown, style) + 12;
    canvas.text({facts_left, top + 20}, shortened(canvas, facts, small, page.right - facts_left),
                small);
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
