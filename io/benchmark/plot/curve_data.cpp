#include "io/benchmark/plot/curve_data.hpp"

#include <algorithm>
#include <cmath>

#include "core/benchmark/curves.hpp"
#include "io/benchmark/wording.hpp"

namespace asv::io {

namespace {

using core::BenchmarkRun;
using core::CostQuartiles;
using geometry::Point;

/// Up by one of `count` steps at each value, then level to the right end.
std::vector<Point> step_line(std::span<const double> ascending, std::size_t count, double end) {
    const auto share = [&](std::size_t steps) {
        return static_cast<double>(steps) / static_cast<double>(count);
    };
    std::vector<Point> line;
    for (std::size_t i = 0; i < ascending.size(); ++i) {
        line.push_back({ascending[i], share(i)});
        line.push_back({ascending[i], share(i + 1)});
    }
    if (!line.empty()) line.push_back({end, line.back().y});
    return line;
}

/// Equally far apart on a logarithmic axis, from the first path of any run to the end of the last.
std::vector<double> times_of(Runs task) {
    constexpr std::size_t count = 120;
    double least = HUGE_VAL, greatest = shortest_time;
    for (const BenchmarkRun& run : task) {
        if (!run.solved()) continue;
        least = std::min(least, std::max(shortest_time, run.spent.time_to_first));
        greatest = std::max(greatest, run.spent.time_total);
    }
    least = std::min(least, greatest);
    std::vector<double> times;
    for (std::size_t i = 0; i < count; ++i)
        times.push_back(least * std::pow(greatest / least,
                                         static_cast<double>(i) / static_cast<double>(count - 1)));
    return times;
}

/// The greatest lower bound known; 0 where there is none.
double bound_of(Runs task) {
    double bound = 0;
    for (const BenchmarkRun& run : task) bound = std::max(bound, run.spent.cost_lower_bound);
    return std::isfinite(bound) ? bound : 0;
}

Curve cost_curve(std::size_t planner, Runs runs, std::span<const double> times, double unit) {
    const std::vector<CostQuartiles> costs = core::cost_over_time(runs, times);
    Curve curve{planner, {}, {}};
    std::vector<Point> below;
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (!costs[i].median.censored)
            curve.line.push_back({times[i], costs[i].median.value / unit});
        if (costs[i].upper.censored) continue;
        curve.band.push_back({times[i], costs[i].upper.value / unit});
        below.push_back({times[i], costs[i].lower.value / unit});
    }
    curve.band.insert(curve.band.end(), below.rbegin(), below.rend());
    return curve;
}

std::vector<Curve> cost_curves(Runs task, std::span<const double> times, double unit) {
    std::vector<Curve> curves;
    for (std::size_t begin = 0, end = 0; begin < task.size(); begin = end) {
        const std::size_t planner = task[begin].place.planner;
        while (end < task.size() && task[end].place.planner == planner) ++end;
        curves.push_back(cost_curve(planner, task.subspan(begin, end - begin), times, unit));
    }
    return curves;
}

/// Around all that is drawn; 0 to 1 where that is nothing.
Axis cost_range(std::span<const Curve> curves) {
    double least = HUGE_VAL, greatest = -HUGE_VAL;
    for (const Curve& curve : curves)
        for (const auto* points : {&curve.line, &curve.band})
            for (const Point& point : *points) {
                least = std::min(least, point.y);
                greatest = std::max(greatest, point.y);
            }
    return least > greatest ? Axis{} : cost_axis(least, greatest, 0, 1);
}

/// Of all times, to the time limit where a run was not solved.
Axis solved_times(const core::BenchmarkPlan& plan, Runs runs) {
    double least = HUGE_VAL, greatest = shortest_time;
    for (const BenchmarkRun& run : runs) {
        const double time = run.solved() ? run.spent.time_to_first : plan.time_limit;
        least = std::min(least, std::max(shortest_time, time));
        greatest = std::max(greatest, time);
    }
    return time_axis(std::min(least, greatest), greatest, 0, 1);
}

}  // namespace

void set_shares(CurvePanel& panel) {
    panel.y = {0, 1.02, 0, 1, false};
    panel.y_is = Quantity::share;
    panel.y_ticks = share_ticks();
}

std::vector<Runs> tasks_of(Runs runs) {
    std::vector<Runs> tasks;
    for (std::size_t begin = 0, end = 0; begin < runs.size(); begin = end) {
        while (end < runs.size() && runs[end].place.problem == runs[begin].place.problem &&
               runs[end].place.direction == runs[begin].place.direction)
            ++end;
        tasks.push_back(runs.subspan(begin, end - begin));
    }
    return tasks;
}

std::string task_title(const core::BenchmarkPlan& plan, Runs task) {
    return plan.problems[task[0].place.problem].name + ", " +
           std::string(core::name(task[0].place.direction));
}

CurvePanel solved_panel(const core::BenchmarkPlan& plan, Runs runs) {
    std::vector<std::vector<double>> times(plan.planners.size());
    std::vector<std::size_t> counts(plan.planners.size());
    for (const BenchmarkRun& run : runs) {
        ++counts[run.place.planner];
        if (run.solved())
            times[run.place.planner].push_back(std::max(shortest_time, run.spent.time_to_first));
    }
    CurvePanel panel;
    panel.caption = "share of runs solved";
    panel.name = "time to the first path";
    panel.x = solved_times(plan, runs);
    panel.x_is = Quantity::seconds;
    panel.x_ticks = time_ticks(panel.x);
    set_shares(panel);
    for (std::size_t planner = 0; planner < counts.size(); ++planner) {
        if (counts[planner] == 0) continue;
        std::sort(times[planner].begin(), times[planner].end());
        panel.curves.push_back(
            {planner, step_line(times[planner], counts[planner], panel.x.high), {}});
    }
    return panel;
}

CurvePanel cost_panel(const core::BenchmarkPlan& plan, Runs task) {
    const core::BenchmarkProblem& problem = plan.problems[task[0].place.problem];
    const std::vector<double> times = times_of(task);
    const double bound = bound_of(task);
    CurvePanel panel;
    panel.title = task_title(plan, task);
    panel.facts = problem_facts(problem.problem, bound);
    panel.caption = std::string("cost of the best path") + (bound > 0 ? " / least possible" : "") +
                    ": median, quartiles";
    panel.name = "time of the run";
    panel.curves = cost_curves(task, times, bound > 0 ? bound : 1);
    panel.x = time_axis(times.front(), times.back(), 0, 1);
    panel.x_is = Quantity::seconds;
    panel.x_ticks = time_ticks(panel.x);
    panel.y = cost_range(panel.curves);
    panel.y_ticks = cost_ticks(panel.y);
    return panel;
}

CurvePanel profile_panel(const BenchmarkReport& report) {
    const auto profiles = core::performance_profiles(report.plan, report.runs);
    double greatest = 2;  // some room where all are equal
    for (const core::PerformanceProfile& profile : profiles)
        if (!profile.factors.empty()) greatest = std::max(greatest, profile.factors.back());
    CurvePanel panel;
    panel.caption = "share of problems and directions";
    panel.name = "median time / that of the best planner, at most";
    panel.x = time_axis(1, greatest, 0, 1);
    panel.x_ticks = factor_ticks(panel.x);
    set_shares(panel);
    for (const core::PerformanceProfile& profile : profiles)
        panel.curves.push_back(
            {profile.planner, step_line(profile.factors, profile.tasks, panel.x.high), {}});
    return panel;
}

}  // namespace asv::io
