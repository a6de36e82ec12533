#include "io/benchmark/plot/curve_panel.hpp"

#include <algorithm>

#include "io/benchmark/plot/plot_page.hpp"
#include "io/benchmark/plot/plot_style.hpp"
#include "io/benchmark/wording.hpp"

namespace asv::io {

namespace {

using geometry::Box;
using geometry::Point;

// In points. The names are beside the field, or in a column below it.
constexpr double field_right = 660, names_left = 690;
constexpr double min_height = 200, name_height = 26;
constexpr double names_below = 60, column_name_height = 20;

/// Of the field.
double field_height(std::size_t curves, PlotLayout layout) {
    if (layout == PlotLayout::column) return min_height;
    return std::max(min_height, name_height * static_cast<double>(curves) + 14);
}

/// Of all of the panel.
double height_for(std::size_t curves, PlotLayout layout) {
    const double names =
        layout == PlotLayout::column ? column_name_height * static_cast<double>(curves) : 0;
    return panel_top + field_height(curves, layout) + panel_bottom + names;
}

/// Draws one panel.
class PanelPainter {
  public:
    PanelPainter(Canvas& canvas, const BenchmarkReport& report, Theme theme,
                 const CurvePanel& panel, double top, PlotLayout layout)
        : canvas_(canvas),
          report_(report),
          theme_(theme),
          colours_(palette(theme)),
          panel_(panel),
          top_(top),
          layout_(layout),
          page_(page_measures(layout)),
          field_{{page_.left, top + panel_top},
                 {layout == PlotLayout::column ? page_.right : field_right,
                  top + panel_top + field_height(panel.curves.size(), layout)}},
          x_(panel.x),
          y_(panel.y) {
        x_.from = field_.low.x, x_.to = field_.high.x;
        y_.from = field_.high.y, y_.to = field_.low.y;
    }

    void draw() {
        const TextStyle small{colours_.muted, tick_size};
        draw_panel_title(canvas_, colours_, panel_.title, panel_.facts, top_, layout_);
        canvas_.text({page_.words, field_.low.y - 10}, panel_.caption, small);
        canvas_.fill_boxes(std::span(&field_, 1), colours_.field);
        draw_level_ticks(canvas_, colours_, field_, y_, panel_.y_ticks);
        draw_upright_ticks(canvas_, colours_, field_, x_, panel_.x_ticks);
        canvas_.text({(field_.low.x + field_.high.x) / 2, field_.high.y + 35},
                     shortened(canvas_, panel_.name, small, field_.high.x - field_.low.x),
                     {colours_.muted, tick_size, false, Align::centre});
        canvas_.push_clip(field_);
        for (const Curve& curve : panel_.curves) draw_band(curve);
        // The first planner comes last, on top of the others.
        for (std::size_t i = panel_.curves.size(); i-- > 0;) draw_line(panel_.curves[i]);
        canvas_.pop_clip();
        for (const Curve& curve : panel_.curves) draw_mark_of(curve);
        for (std::size_t i = 0; i < panel_.curves.size(); ++i) draw_name(i);
    }

  private:
    std::vector<Point> on_page(std::span<const Point> points) const {
        std::vector<Point> places;
        for (const Point& point : points) places.push_back({x_.at(point.x), y_.at(point.y)});
        return places;
    }

    void draw_band(const Curve& curve) {
        if (curve.band.empty()) return;
        canvas_.fill_polygon(on_page(curve.band),
                             faded(planner_colour(curve.planner, theme_), 0.16));
    }

    void draw_line(const Curve& curve) {
        if (curve.line.empty()) return;
        canvas_.stroke_line(on_page(curve.line), {planner_colour(curve.planner, theme_), 1.8});
    }

    void draw_mark_of(const Curve& curve) {
        if (curve.line.empty()) return;
        const Point& middle = curve.line[curve.line.size() / 2];
        draw_mark(canvas_, curve.planner, {x_.at(middle.x), y_.at(middle.y)}, 4,
                  planner_colour(curve.planner, theme_), false, colours_.field);
    }

    void draw_name(std::size_t row) {
        const std::size_t planner = panel_.curves[row].planner;
        const Point at = name_place(static_cast<double>(row));
        const TextStyle style{colours_.ink, text_size};
        const std::string label = report_.plan.planners[planner].label +
                                  (panel_.curves[row].line.empty() ? " (no curve)" : "");
        draw_mark(canvas_, planner, at, 4.5, planner_colour(planner, theme_), false, colours_.page);
        canvas_.text({at.x + 14, at.y + 4.5},
                     shortened(canvas_, label, style, page_.right - at.x - 14), style);
    }

    Point name_place(double row) const {
        if (layout_ == PlotLayout::column)
            return {page_.left + 8, field_.high.y + names_below + column_name_height * row};
        return {names_left, field_.low.y + 22 + name_height * row};
    }

    Canvas& canvas_;
    const BenchmarkReport& report_;
    Theme theme_;
    const Palette& colours_;
    const CurvePanel& panel_;
    double top_;
    PlotLayout layout_;
    PageMeasures page_;
    Box field_;
    Axis x_, y_;
};

}  // namespace

std::size_t curve_panels_on_page(std::size_t curves, PlotLayout layout) {
    const double room = greatest_page - greatest_header - below_panels;
    const double each = height_for(curves, layout);
    return std::max<std::size_t>(1, static_cast<std::size_t>(room / each));
}

std::string draw_curve_panels(const BenchmarkReport& report, const std::string& title,
                              std::span<const CurvePanel> panels, PictureFormat format, Theme theme,
                              PlotLayout layout) {
    const auto height_of = [&](const CurvePanel& panel) {
        return height_for(panel.curves.size(), layout);
    };
    double top = header_height(report, layout), height = top + below_panels;
    for (const CurvePanel& panel : panels) height += height_of(panel);
    Canvas canvas(format, page_measures(layout).width, height, 2);
    canvas.fill_all(palette(theme).page);
    draw_header(canvas, palette(theme), report, title, layout);
    for (const CurvePanel& panel : panels) {
        PanelPainter(canvas, report, theme, panel, top, layout).draw();
        top += height_of(panel);
    }
    return canvas.finish(title, plan_facts(report.plan));
}

}  // namespace asv::io
