#include "core/shapes/flat_chain.hpp"

#include <numbers>
#include <stdexcept>
#include <string>

#include "geometry/elementary/functions.hpp"

namespace asv::core {

namespace {

/// A rise from the lower to the upper wall: how many brooms, and half the angle at which each is
/// seen from the centre of the circle through its joints.
struct Rise {
    std::size_t brooms = 1;
    double half_angle = 0;
};

double rise_height(double brooms, double half_angle, double broom_length) {
    return broom_length * elementary::sin(2 * brooms * half_angle) /
           (2 * elementary::sin(half_angle));
}

/// At this half angle the last broom of the rise is level.
double level_half_angle(double brooms) {
    return std::numbers::pi / (2 * (2 * brooms - 1));
}

/// The only half angle at which so many brooms rise to the height: the height falls steadily from
/// brooms * broom_length at 0 to that of the level last broom.
double solve_half_angle(std::size_t brooms, double broom_length, double height) {
    const auto count = static_cast<double>(brooms);
    double low = 0;
    double high = level_half_angle(count);
    for (int i = 0; i < 200 && low < high; ++i) {
        const double middle = (low + high) / 2;
        if (middle == low || middle == high) break;
        (rise_height(count, middle, broom_length) > height ? low : high) = middle;
    }
    return high;
}

Rise best_rise(std::size_t brooms, double broom_length, double height) {
    if (brooms < 2 || !(broom_length > 0) || !(height > 0) ||
        !(height <= static_cast<double>(brooms) * broom_length / 5))
        throw std::invalid_argument("flat chain: no " + std::to_string(brooms) +
                                    " brooms lie along a strip of height " +
                                    std::to_string(height));
    std::size_t count = 1;
    while (2 * (count + 1) <= brooms) {
        const auto next = static_cast<double>(count + 1);
        if (height < rise_height(next, level_half_angle(next), broom_length)) break;
        ++count;
    }
    return {count, solve_half_angle(count, broom_length, height)};
}

}  // namespace

double flat_area(std::size_t brooms, double broom_length, double height) {
    const Rise rise = best_rise(brooms, broom_length, height);
    const auto count = static_cast<double>(rise.brooms);
    const double a = rise.half_angle;
    const double radius = broom_length / (2 * elementary::sin(a));
    const double below_rise =
        radius * radius / 4 * (2 * count * elementary::sin(2 * a) - elementary::sin(4 * count * a));
    const double level = (static_cast<double>(brooms) - 2 * count) * broom_length;
    return level * height + 2 * below_rise;
}

double min_flat_height(std::size_t asv_count, const Requirements& requirements) {
    if (asv_count < 3)
        throw std::invalid_argument("flat chain: " + std::to_string(asv_count) +
                                    " ASVs enclose no area");
    const std::size_t brooms = asv_count - 1;
    const double wanted = requirements.min_area(asv_count);
    double low = 0;
    double high = static_cast<double>(brooms) * requirements.broom_length / 5;
    if (flat_area(brooms, requirements.broom_length, high) < wanted)
        throw std::invalid_argument("flat chain: the minimum area is too large for a flat shape");
    while (true) {
        const double middle = (low + high) / 2;
        if (middle == low || middle == high) return high;
        (flat_area(brooms, requirements.broom_length, middle) < wanted ? low : high) = middle;
    }
}

std::vector<double> flat_chain_turns(std::size_t asv_count, double broom_length, double height) {
    const std::size_t brooms = asv_count - 1;
    const Rise rise = best_rise(brooms, broom_length, height);
    std::vector<double> turns(asv_count - 2, 0.0);
    for (std::size_t i = 0; i + 1 < rise.brooms; ++i) {
        turns[i] = 2 * rise.half_angle;
        turns[turns.size() - 1 - i] = 2 * rise.half_angle;
    }
    const double last = static_cast<double>(2 * rise.brooms - 1) * rise.half_angle;
    const double corner = std::numbers::pi / 2 - last;
    turns[rise.brooms - 1] += corner;
    turns[turns.size() - rise.brooms] += corner;
    return turns;
}

double flat_chain_heading(std::size_t asv_count, double broom_length, double height) {
    return std::numbers::pi / 2 - best_rise(asv_count - 1, broom_length, height).half_angle;
}

double round_diameter(std::size_t asv_count, const Requirements& requirements) {
    if (asv_count < 3) throw std::invalid_argument("round chain: at least 3 ASVs are needed");
    return requirements.broom_length /
           elementary::sin(std::numbers::pi / static_cast<double>(asv_count));
}

}  // namespace asv::core
