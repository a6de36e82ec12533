#include "core/certificate_check/facing.hpp"

#include <algorithm>

namespace asv::core::certificate_check {

namespace {

struct Span {
    Number low, high;
};

Span across(const Box& box, bool upright) {
    return upright ? Span{exact(box.low.x), exact(box.high.x)}
                   : Span{exact(box.low.y), exact(box.high.y)};
}

std::optional<std::string> fault_of(const FacingWalls& facing, const Problem& problem,
                                    const Limits& limits) {
    for (const auto& wall : facing.walls) {
        if (!wall && !problem.requirements.bounded()) return "there is no border";
        if (!wall) continue;
        const std::string name = "obstacle " + std::to_string(*wall + 1);
        if (*wall >= problem.obstacles.size()) return "there is no " + name;
        const Span thick = across(problem.obstacles[*wall], facing.upright);
        if (thick.high - thick.low <= 2 * limits.shrink)
            return "a step may lead over " + name + ", which is that thin";
    }
    if (!facing.walls[0] && !facing.walls[1]) return "there is no obstacle";
    return std::nullopt;
}

/// Where both obstacles are; the border is everywhere.
Span common(const FacingWalls& facing, const Problem& problem) {
    std::optional<Span> both;
    for (const auto& wall : facing.walls) {
        if (!wall) continue;
        const Span along = across(problem.obstacles[*wall], !facing.upright);
        if (!both) both = along;
        both = Span{std::max(both->low, along.low), std::min(both->high, along.high)};
    }
    return *both;
}

}  // namespace

Rectangle Passage::cross_section(const Number& along) const {
    return upright ? Rectangle{near, far, along, along} : Rectangle{along, along, near, far};
}

Passage passage_between(const FacingWalls& facing, const Problem& problem, const Limits& limits) {
    Passage passage;
    passage.upright = facing.upright;
    passage.fault = fault_of(facing, problem, limits);
    if (passage.fault) return passage;
    const Box& bounds = problem.requirements.bounds;
    const auto& [first, second] = facing.walls;
    // The walls turn these sides to each other; the outside of the bounds begins where they end.
    const Number low = first ? across(problem.obstacles[*first], facing.upright).high
                             : across(bounds, facing.upright).low;
    const Number high = second ? across(problem.obstacles[*second], facing.upright).low
                               : across(bounds, facing.upright).high;
    const Span along = common(facing, problem);
    passage.gap = high - low;
    passage.from = along.low;
    passage.to = along.high;
    passage.near = low - (first ? limits.shrink : limits.tolerance);
    passage.far = high + (second ? limits.shrink : limits.tolerance);
    if (passage.from >= passage.to || passage.near > passage.far)
        passage.fault = describe(facing) + " do not face each other like that";
    return passage;
}

std::string describe(const FacingWalls& facing) {
    const auto& [first, second] = facing.walls;
    if (first && second)
        return "obstacles " + std::to_string(*first + 1) + " and " + std::to_string(*second + 1);
    const std::size_t obstacle = first ? *first : second.value();
    return "obstacle " + std::to_string(obstacle + 1) + " and the border";
}

}  // namespace asv::core::certificate_check
