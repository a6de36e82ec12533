#include "core/bounds/passages/gate_sections.hpp"

#include <algorithm>
#include <optional>

#include "geometry/boxes/span.hpp"

namespace asv::core {

namespace {

using geometry::Box;
using geometry::Span;

/// Where the sections are, from one end of the gate to the other.
constexpr std::array places_along{0.5, 0.0, 1.0};

enum class Along { x, y };

/// Along which axis a way goes through the gate; none where the gate lies between corners.
std::optional<Along> direction_of(const geometry::Gate& gate, std::span<const Box> walls) {
    const Box& first = walls[gate.sides[0]];
    if (gate.sides[1] >= walls.size()) {
        const bool left_or_right = gate.sides[1] < walls.size() + 2;
        return left_or_right ? Along::y : Along::x;
    }
    const Box& second = walls[gate.sides[1]];
    if (apart(x_span(first), x_span(second)) < 0) return Along::x;
    if (apart(y_span(first), y_span(second)) < 0) return Along::y;
    return std::nullopt;
}

/// The part of a span, of such a length, that is around a place from 0 to 1 along it.
Span part_of(const Span& span, double place, double length) {
    const double low = span.low + place * (span.high - span.low) - length / 2;
    const double begin = std::clamp(low, span.low, std::max(span.low, span.high - length));
    return {begin, std::min(begin + length, span.high)};
}

}  // namespace

std::vector<GateSection> sections_of(const geometry::Gate& gate, std::span<const Box> walls,
                                     double thickness) {
    const auto along = direction_of(gate, walls);
    if (!along) return {{gate.sides, 0, gate.gap}};
    std::vector<GateSection> sections;
    for (const double place : places_along) {
        Box across = gate.gap;
        const bool is_x = *along == Along::x;
        const Span part = part_of(is_x ? x_span(across) : y_span(across), place, thickness);
        (is_x ? across.low.x : across.low.y) = part.low;
        (is_x ? across.high.x : across.high.y) = part.high;
        sections.push_back({gate.sides, sections.size(), across});
    }
    return sections;
}

}  // namespace asv::core
