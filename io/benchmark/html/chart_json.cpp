#include "io/benchmark/html/chart_json.hpp"

#include <cmath>
#include <span>
#include <vector>

#include <nlohmann/json.hpp>

#include "io/benchmark/html/colour_text.hpp"
#include "io/benchmark/plot/curve_data.hpp"
#include "io/benchmark/plot/parameter_panels.hpp"
#include "io/benchmark/plot/plot_style.hpp"

namespace asv::io {

namespace {

using geometry::Point;
using nlohmann::ordered_json;

/// With the digits that can be seen, which make a page a third as large.
double rounded(double value) {
    constexpr int digits = 6;
    if (value == 0 || !std::isfinite(value)) return 0;
    const double scale = std::pow(10, digits - 1 - std::floor(std::log10(std::abs(value))));
    return std::round(value * scale) / scale;
}

/// Without the points in the middle of level parts.
ordered_json points_json(std::span<const Point> points) {
    ordered_json list = ordered_json::array();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool inside = i > 0 && i + 1 < points.size();
        if (inside && points[i - 1].y == points[i].y && points[i + 1].y == points[i].y) continue;
        list.push_back({rounded(points[i].x), rounded(points[i].y)});
    }
    return list;
}

ordered_json curve_json(const Curve& curve) {
    return {{"planner", curve.planner},
            {"line", points_json(curve.line)},
            {"band", points_json(curve.band)}};
}

ordered_json axis_json(const Axis& axis, Quantity quantity, const std::vector<Tick>& ticks,
                       const std::string& name) {
    constexpr const char* quantities[] = {"number", "seconds", "share"};
    ordered_json list = ordered_json::array();
    for (const Tick& tick : ticks) list.push_back({tick.value, tick.label});
    return {{"name", name},
            {"low", axis.low},
            {"high", axis.high},
            {"logarithmic", axis.logarithmic},
            {"quantity", quantities[static_cast<std::size_t>(quantity)]},
            {"ticks", std::move(list)}};
}

ordered_json panel_json(const CurvePanel& panel) {
    ordered_json curves = ordered_json::array();
    for (const Curve& curve : panel.curves) curves.push_back(curve_json(curve));
    return {{"title", panel.title},
            {"facts", panel.facts},
            {"x", axis_json(panel.x, panel.x_is, panel.x_ticks, panel.name)},
            {"y", axis_json(panel.y, panel.y_is, panel.y_ticks, panel.caption)},
            {"curves", std::move(curves)}};
}

ordered_json chart(const std::string& title, std::span<const CurvePanel> panels) {
    ordered_json list = ordered_json::array();
    for (const CurvePanel& panel : panels) list.push_back(panel_json(panel));
    return {{"title", title}, {"panels", std::move(list)}};
}

ordered_json planners_json(const core::BenchmarkPlan& plan) {
    ordered_json list = ordered_json::array();
    for (std::size_t i = 0; i < plan.planners.size(); ++i)
        list.push_back({{"label", plan.planners[i].label},
                        {"light", colour_text(planner_colour(i, Theme::light))},
                        {"dark", colour_text(planner_colour(i, Theme::dark))}});
    return list;
}

/// All runs together, where they are of several tasks, then each task.
std::vector<CurvePanel> solved_panels(const BenchmarkReport& report,
                                      const std::vector<Runs>& tasks) {
    std::vector<CurvePanel> panels;
    if (tasks.size() > 1) {
        panels.push_back(solved_panel(report.plan, report.runs));
        panels.back().title = "all " + std::to_string(tasks.size()) + " problems and directions";
    }
    for (const Runs& task : tasks) {
        panels.push_back(solved_panel(report.plan, task));
        panels.back().title = task_title(report.plan, task);
    }
    return panels;
}

}  // namespace

std::string chart_json(const BenchmarkReport& report) {
    const std::vector<Runs> tasks = tasks_of(report.runs);
    std::vector<CurvePanel> costs;
    for (const Runs& task : tasks) costs.push_back(cost_panel(report.plan, task));
    const CurvePanel profile = profile_panel(report);
    ordered_json charts = {chart("Solved over time", solved_panels(report, tasks)),
                           chart("Cost over time", costs),
                           chart("Performance profiles", std::span(&profile, 1))};
    if (!report.parameter.empty()) {
        const std::vector<CurvePanel> panels = parameter_panels(report);
        charts.push_back(chart("Over " + panels[0].name, panels));
    }
    const ordered_json json = {{"planners", planners_json(report.plan)},
                               {"charts", std::move(charts)}};
    // A label need not be UTF-8.
    return json.dump(-1, ' ', true, ordered_json::error_handler_t::replace);
}

}  // namespace asv::io
