#include "io/benchmark/plot/plot_axis.hpp"

#include <array>
#include <cmath>

#include "io/text/number_text.hpp"

namespace asv::io {

namespace {

constexpr std::array<double, 3> round_figures{1, 2, 5};

/// The greatest of 1, 2 and 5 times a power of ten that is not above the value.
double round_down(double value) {
    const double power = std::pow(10, std::floor(std::log10(value)));
    double result = power / 2;
    for (const double figure : round_figures)
        if (figure * power <= value * (1 + 1e-12)) result = figure * power;
    return result;
}

double round_up(double value) {
    const double below = round_down(value);
    if (below >= value * (1 - 1e-12)) return below;
    for (const double factor : {2.0, 2.5})
        if (below * factor >= value && round_down(below * factor) >= below * factor * (1 - 1e-9))
            return below * factor;
    return 10 * below;
}

/// Without the rounding that powers of ten bring in.
std::string tidy(double value) {
    const double scale = std::pow(10, 6 - std::floor(std::log10(std::abs(value) + 1e-300)));
    std::string text;
    append_number(text, value == 0 ? 0 : std::round(value * scale) / scale);
    return text;
}

std::string time_label(double seconds) {
    if (seconds >= 0.999) return tidy(seconds) + " s";
    if (seconds >= 0.999e-3) return tidy(1e3 * seconds) + " ms";
    return tidy(1e6 * seconds) + " \u00b5s";
}

/// Of a logarithmic axis.
std::vector<Tick> round_ticks(const Axis& axis, std::string (*label)(double)) {
    const bool few = axis.high < 99 * axis.low;
    std::vector<Tick> ticks;
    const double first = std::floor(std::log10(axis.low) + 1e-9);
    for (double exponent = first; std::pow(10, exponent) < axis.high * 1.001; ++exponent)
        for (const double figure : round_figures) {
            const double value = figure * std::pow(10, exponent);
            const bool inside = value > axis.low * 0.999 && value < axis.high * 1.001;
            if (inside && (few || figure == 1)) ticks.push_back({value, label(value)});
        }
    return ticks;
}

}  // namespace

double Axis::at(double value) const {
    const double share =
        logarithmic ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
    return from + share * (to - from);
}

Axis time_axis(double least, double greatest, double from, double to) {
    double low = round_down(least);
    const double high = round_up(greatest);
    if (low >= high) low = high / 2;
    return {low, high, from, to, true};
}

std::vector<Tick> time_ticks(const Axis& axis) {
    return round_ticks(axis, time_label);
}

std::vector<Tick> factor_ticks(const Axis& axis) {
    return round_ticks(axis, tidy);
}

std::vector<Tick> share_ticks() {
    return {{0, "0 %"}, {0.25, ""}, {0.5, "50 %"}, {0.75, ""}, {1, "100 %"}};
}

Axis cost_axis(double least, double greatest, double from, double to) {
    const double room =
        greatest > least ? 0.04 * (greatest - least) : 0.05 * std::abs(least) + 1e-9;
    return {least - room, greatest + room, from, to, false};
}

std::vector<Tick> cost_ticks(const Axis& axis, double most_steps) {
    const double step = round_up((axis.high - axis.low) / most_steps);
    std::vector<Tick> ticks;
    for (double k = std::ceil(axis.low / step); k * step <= axis.high; ++k)
        ticks.push_back({k * step, tidy(k * step)});
    return ticks;
}

}  // namespace asv::io
