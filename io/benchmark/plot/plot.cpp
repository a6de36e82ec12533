#include "io/benchmark/plot/plot.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/benchmark/statistics/statistics.hpp"
#include "io/benchmark/plot/plot_axis.hpp"
#include "io/benchmark/plot/plot_data.hpp"
#include "io/benchmark/plot/plot_page.hpp"
#include "io/benchmark/plot/plot_style.hpp"
#include "io/benchmark/wording.hpp"

namespace asv::io {

namespace {

using core::Direction;
using geometry::Box;
using geometry::Point;
using geometry::Segment;

// In points.
constexpr double times_right = 500;
constexpr double names_left = 526, costs_left = 690;
constexpr double column_costs_left = 150, times_to_costs = 14;
constexpr double times_height = 150, row_height = 26, second_row = 16;
constexpr double ticks_height = 34;  // below costs
constexpr double legend_height = 24;
constexpr double mark_room = 6;  // left of the middle of a mark
constexpr double column_cost_steps = 3;

/// One row for each planner; two where both directions ran.
double rows_height(const PlotPanel& panel) {
    double height = 14;
    for (std::size_t i = 0; i < panel.series.size(); ++i)
        height += i > 0 && panel.series[i - 1].planner == panel.series[i].planner ? second_row
                                                                                  : row_height;
    return height;
}

/// The parts of a panel on the page.
struct PanelParts {
    Box times, costs;
    double names;  ///< where the marks before them are
    double bottom;
};

/// Costs are beside the times, or in a column below them.
PanelParts panel_parts(const PlotPanel& panel, double top, PlotLayout layout) {
    const PageMeasures page = page_measures(layout);
    const double high = top + panel_top;
    if (layout == PlotLayout::column) {
        const double low = high + times_height;
        const double costs_high = low + panel_bottom + times_to_costs,
                     costs_low = costs_high + rows_height(panel);
        return {{{page.left, high}, {page.right, low}},
                {{column_costs_left, costs_high}, {page.right, costs_low}},
                page.words + mark_room,
                costs_low + ticks_height};
    }
    const double low = high + std::max(times_height, rows_height(panel));
    return {{{page.left, high}, {times_right, low}},
            {{costs_left, high}, {page.right, low}},
            names_left,
            low + panel_bottom};
}

/// Of the ticks below costs: in a column there is room for a few.
double cost_steps(PlotLayout layout) {
    return layout == PlotLayout::column ? column_cost_steps : most_cost_steps;
}

bool both_directions(const BenchmarkReport& report) {
    return report.plan.directions.size() > 1;
}

/// Draws the panels one below the other.
class Plotter {
  public:
    Plotter(const BenchmarkReport& report, Canvas& canvas, Theme theme, PlotLayout layout)
        : report_(report),
          canvas_(canvas),
          theme_(theme),
          layout_(layout),
          colours_(palette(theme)) {}

    void header() {
        const core::BenchmarkPlan& plan = report_.plan;
        draw_header(canvas_, colours_, report_,
                    plural(plan.planners.size(), "planner") + " on " +
                        plural(plan.problems.size(), "problem"),
                    layout_);
        if (both_directions(report_)) direction_legend();
    }

    void panel(const PlotPanel& panel, const Axis& times, double top) {
        const PanelParts parts = panel_parts(panel, top, layout_);
        draw_panel_title(canvas_, colours_, panel.title, panel.facts, top, layout_);
        caption({page_measures(layout_).words, parts.times.low.y - 10}, "share of runs solved");
        caption({parts.costs.low.x, parts.costs.low.y - 10},
                panel.relative ? "cost of the path / least possible" : "cost of the path");
        draw_times(panel, times, parts.times);
        draw_costs(panel, parts.costs, parts.names);
    }

  private:
    void write(const Point& at, const std::string& text, const TextStyle& style) {
        canvas_.text(at, text, style);
    }

    void caption(const Point& at, const std::string& text) {
        write(at, text, {colours_.muted, tick_size});
    }

    void direction_legend() {
        const bool column = layout_ == PlotLayout::column;
        const double y = column ? header_height(report_, layout_) + 14 : 58;
        const double left =
            column ? page_measures(layout_).left : page_measures(layout_).right - 212;
        for (const Direction direction : report_.plan.directions) {
            const bool reversed = direction == Direction::reversed;
            const double x = reversed ? left + 116 : left;
            const Segment line{{x, y}, {x + 30, y}};
            canvas_.stroke_segments(std::span(&line, 1), stroke(colours_.ink, direction));
            draw_mark(canvas_, 0, {x + 15, y}, 3.6, colours_.ink, reversed, colours_.page);
            write({x + 38, y + 4}, std::string(core::name(direction)), {colours_.ink, text_size});
        }
    }

    Stroke stroke(const Colour& colour, Direction direction) const {
        if (direction == Direction::forward) return {colour, 1.8};
        return {colour, 1.8, {5, 4}};
    }

    void frame(const Box& box) { canvas_.fill_boxes(std::span(&box, 1), colours_.field); }

    void draw_times(const PlotPanel& panel, const Axis& times, const Box& box) {
        frame(box);
        const Axis shares{0, 1, box.high.y, box.low.y, false};
        draw_level_ticks(canvas_, colours_, box, shares, share_ticks());
        draw_upright_ticks(canvas_, colours_, box, times, time_ticks(times));
        write({(box.low.x + box.high.x) / 2, box.high.y + 35}, "time to the first path",
              {colours_.muted, tick_size, false, Align::centre});
        // The first planner comes last, on top of the others.
        for (std::size_t i = panel.series.size(); i-- > 0;)
            draw_curve(panel.series[i], times, shares, box);
    }

    void draw_curve(const PlotSeries& series, const Axis& times, const Axis& shares,
                    const Box& box) {
        const Colour colour = planner_colour(series.planner, theme_);
        if (series.times.empty()) return draw_no_curve(series, shares, box);
        std::vector<Point> curve;
        double share = 0;
        for (const double time : series.times) {
            curve.push_back({times.at(time), shares.at(share)});
            share += 1 / static_cast<double>(series.runs);
            curve.push_back({times.at(time), shares.at(share)});
        }
        canvas_.stroke_line(curve, stroke(colour, series.direction));
        // On from the last run, weaker: curves that are done lie on top of each other.
        const Segment rest{curve.back(), {box.high.x, curve.back().y}};
        canvas_.stroke_segments(std::span(&rest, 1), {faded(colour, 0.35), 1.2});
        for (const double mark : {0.5, 1.0}) {
            const auto last = static_cast<double>(series.times.size() - 1);
            const auto i = static_cast<std::size_t>(mark * last);
            draw_mark(canvas_, series.planner, curve[2 * i + 1], 4, colour,
                      series.direction == Direction::reversed, colours_.field);
        }
    }

    /// No run is solved at any time: a line along the bottom, so that the planner is not missed.
    void draw_no_curve(const PlotSeries& series, const Axis& shares, const Box& box) {
        const Colour colour = planner_colour(series.planner, theme_);
        const Segment none{{box.low.x, shares.at(0)}, {box.high.x, shares.at(0)}};
        canvas_.stroke_segments(std::span(&none, 1), stroke(colour, series.direction));
        draw_mark(canvas_, series.planner, none.b, 4, colour,
                  series.direction == Direction::reversed, colours_.field);
    }

    void draw_costs(const PlotPanel& panel, const Box& box, double names) {
        frame(box);
        double least = panel.relative ? 1 : HUGE_VAL, greatest = panel.relative ? 1.02 : -HUGE_VAL;
        for (const PlotSeries& series : panel.series)
            for (const double cost : series.costs) {
                least = std::min(least, cost);
                greatest = std::max(greatest, cost);
            }
        if (least > greatest) least = 0, greatest = 1;
        const Axis costs = cost_axis(least, greatest, box.low.x, box.high.x);
        draw_upright_ticks(canvas_, colours_, box, costs, cost_ticks(costs, cost_steps(layout_)));
        double y = box.low.y + 22;
        for (std::size_t i = 0; i < panel.series.size(); ++i) {
            const PlotSeries& series = panel.series[i];
            const bool second = i > 0 && panel.series[i - 1].planner == series.planner;
            if (i > 0) y += second ? second_row : row_height;
            if (!second) draw_name(series.planner, {names, y}, box.low.x);
            draw_row(series, costs, y);
        }
    }

    void draw_name(std::size_t planner, const Point& at, double right) {
        const TextStyle style{colours_.ink, text_size};
        draw_mark(canvas_, planner, at, 4.5, planner_colour(planner, theme_), false, colours_.page);
        write({at.x + 14, at.y + 4.5},
              shortened(canvas_, report_.plan.planners[planner].label, style, right - at.x - 24),
              style);
    }

    /// Quartiles as a bar, the median as a line, every run as a mark.
    void draw_row(const PlotSeries& series, const Axis& costs, double y) {
        if (series.costs.empty()) {
            write({costs.from + 8, y + 4}, "no run solved", {colours_.muted, tick_size});
            return;
        }
        const Colour colour = planner_colour(series.planner, theme_);
        const auto place = [&](double share) {
            return costs.at(core::statistics::quantile(series.costs, share));
        };
        const Box quartiles{{place(0.25), y - 6}, {place(0.75), y + 6}};
        canvas_.fill_boxes(std::span(&quartiles, 1), faded(colour, 0.22));
        const Segment range{{place(0), y}, {place(1), y}};
        canvas_.stroke_segments(std::span(&range, 1), {faded(colour, 0.45), 1});
        for (const double cost : series.costs)
            draw_mark(canvas_, series.planner, {costs.at(cost), y}, 2.6, faded(colour, 0.7),
                      series.direction == Direction::reversed, colours_.field);
        const Segment median{{place(0.5), y - 7}, {place(0.5), y + 7}};
        canvas_.stroke_segments(std::span(&median, 1), {colour, 2.4});
    }

    const BenchmarkReport& report_;
    Canvas& canvas_;
    Theme theme_;
    PlotLayout layout_;
    const Palette& colours_;
};

/// One axis for all panels, so that they can be compared; to the time limit where a run was not
/// solved.
Axis common_times(const BenchmarkReport& report, std::span<const PlotPanel> panels,
                  PlotLayout layout) {
    double least = HUGE_VAL, greatest = 0;
    for (const PlotPanel& panel : panels)
        for (const PlotSeries& series : panel.series) {
            if (series.times.size() < series.runs) greatest = report.plan.time_limit;
            if (series.times.empty()) continue;
            least = std::min(least, series.times.front());
            greatest = std::max(greatest, series.times.back());
        }
    greatest = std::clamp(greatest, 1e-6, 1e9);
    const Box times = panel_parts({}, 0, layout).times;
    return time_axis(std::clamp(least, 1e-6, greatest), greatest, times.low.x, times.high.x);
}

/// Where the first panel begins.
double panels_top(const BenchmarkReport& report, PlotLayout layout) {
    const bool legend = layout == PlotLayout::column && both_directions(report);
    return header_height(report, layout) + (legend ? legend_height : 0);
}

double page_height(const BenchmarkReport& report, std::span<const PlotPanel> panels,
                   PlotLayout layout) {
    double bottom = panels_top(report, layout);
    for (const PlotPanel& panel : panels) bottom = panel_parts(panel, bottom, layout).bottom;
    return bottom + below_panels;
}

}  // namespace

std::string draw_benchmark(const BenchmarkReport& report, PictureFormat format, Theme theme,
                           PlotLayout layout) {
    std::vector<PlotPanel> panels = plot_panels(report, report.plan.problems.size());
    if (page_height(report, panels, layout) > greatest_page) panels = plot_panels(report, 0);
    Canvas canvas(format, page_measures(layout).width, page_height(report, panels, layout), 2);
    canvas.fill_all(palette(theme).page);
    Plotter plotter(report, canvas, theme, layout);
    plotter.header();
    const Axis times = common_times(report, panels, layout);
    double top = panels_top(report, layout);
    for (const PlotPanel& panel : panels) {
        plotter.panel(panel, times, top);
        top = panel_parts(panel, top, layout).bottom;
    }
    return canvas.finish("Benchmark: share of runs solved over time, and costs",
                         plan_facts(report.plan));
}

}  // namespace asv::io
