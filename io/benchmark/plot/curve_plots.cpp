#include "io/benchmark/plot/curve_plots.hpp"

#include <span>
#include <vector>

#include "io/benchmark/plot/curve_data.hpp"
#include "io/benchmark/plot/curve_panel.hpp"
#include "io/benchmark/plot/parameter_panels.hpp"

namespace asv::io {

std::string draw_profiles(const BenchmarkReport& report, PictureFormat format, Theme theme,
                          PlotLayout layout) {
    const std::string title = "Performance profiles";
    CurvePanel panel = profile_panel(report);
    if (layout == PlotLayout::column) panel.title = title;  // it has no heading
    return draw_curve_panels(report, title, std::span(&panel, 1), format, theme, layout);
}

std::string draw_costs_over_time(const BenchmarkReport& report, PictureFormat format, Theme theme,
                                 PlotLayout layout) {
    std::string title = "Cost over time";
    std::vector<Runs> tasks = tasks_of(report.runs);
    const std::size_t all = tasks.size();
    const std::size_t most = curve_panels_on_page(report.plan.planners.size(), layout);
    if (all > most) {
        title += ": the first " + std::to_string(most) + " of " + std::to_string(all) +
                 " problems and directions";
        tasks.resize(most);
    }
    std::vector<CurvePanel> panels;
    for (const Runs& task : tasks) panels.push_back(cost_panel(report.plan, task));
    if (all > most && layout == PlotLayout::column)
        panels.back().name +=
            " (" + std::to_string(most) + " of " + std::to_string(all) + " problems)";
    return draw_curve_panels(report, title, panels, format, theme, layout);
}

std::string draw_parameter(const BenchmarkReport& report, PictureFormat format, Theme theme,
                           PlotLayout layout) {
    const std::vector<CurvePanel> panels = parameter_panels(report);
    return draw_curve_panels(report, "Over " + panels[0].name, panels, format, theme, layout);
}

}  // namespace asv::io
