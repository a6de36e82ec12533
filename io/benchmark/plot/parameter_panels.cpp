#include "io/benchmark/plot/parameter_panels.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "core/benchmark/parameter_curves.hpp"

namespace asv::io {

namespace {

using core::ParameterCurve;
using core::ParameterPoint;

/// A line and the band between two values of each point.
template <class Value, class Low, class High>
Curve curve_of(std::size_t planner, const std::vector<ParameterPoint>& points, const Value& value,
               const Low& low, const High& high) {
    Curve curve{planner, {}, {}};
    for (const ParameterPoint& point : points) {
        curve.line.push_back({point.value, value(point)});
        curve.band.push_back({point.value, high(point)});
    }
    for (auto point = points.rbegin(); point != points.rend(); ++point)
        curve.band.push_back({point->value, low(*point)});
    return curve;
}

Curve time_curve(const ParameterCurve& all) {
    const auto seconds = [](const core::statistics::CensoredValue& time) {
        return std::max(shortest_time, time.value);
    };
    std::vector<ParameterPoint> known;
    std::copy_if(all.points.begin(), all.points.end(), std::back_inserter(known),
                 [](const ParameterPoint& point) { return !point.median_time.censored; });
    return curve_of(
        all.planner, known, [&](const ParameterPoint& point) { return seconds(point.median_time); },
        [&](const ParameterPoint& point) { return seconds(point.median_interval.low); },
        [&](const ParameterPoint& point) { return seconds(point.median_interval.high); });
}

Curve share_curve(const ParameterCurve& all) {
    return curve_of(
        all.planner, all.points,
        [](const ParameterPoint& point) {
            return static_cast<double>(point.solved) / static_cast<double>(point.runs);
        },
        [](const ParameterPoint& point) { return point.success.low; },
        [](const ParameterPoint& point) { return point.success.high; });
}

/// The axis of what goes up in all curves.
Axis times_around(const std::vector<Curve>& curves, double time_limit) {
    double least = HUGE_VAL, greatest = 0;
    for (const Curve& curve : curves)
        for (const geometry::Point& point : curve.band) {
            least = std::min(least, point.y);
            greatest = std::max(greatest, point.y);
        }
    if (least > greatest) least = greatest = std::max(shortest_time, time_limit);
    return time_axis(least, greatest, 0, 1);
}

CurvePanel empty_panel(const std::vector<ParameterCurve>& curves, const std::string& name) {
    double least = HUGE_VAL, greatest = -HUGE_VAL;
    for (const ParameterCurve& curve : curves) {
        least = std::min(least, curve.points.front().value);
        greatest = std::max(greatest, curve.points.back().value);
    }
    CurvePanel panel;
    panel.name = name == "n" ? "number of ASVs" : name;
    if (least <= greatest) panel.x = cost_axis(least, greatest, 0, 1);
    panel.x_ticks = cost_ticks(panel.x);
    return panel;
}

}  // namespace

std::vector<CurvePanel> parameter_panels(const BenchmarkReport& report) {
    const auto curves = core::parameter_curves(report.plan, report.runs, report.parameter);
    CurvePanel times = empty_panel(curves, report.parameter), shares = times;
    times.title = "Time";
    times.caption = "median time to the first path, 95 % interval";
    for (const ParameterCurve& curve : curves) times.curves.push_back(time_curve(curve));
    times.y = times_around(times.curves, report.plan.time_limit);
    times.y_is = Quantity::seconds;
    times.y_ticks = time_ticks(times.y);
    shares.title = "Success";
    shares.caption = "share of runs solved, 95 % interval";
    for (const ParameterCurve& curve : curves) shares.curves.push_back(share_curve(curve));
    set_shares(shares);
    return {times, shares};
}

}  // namespace asv::io
