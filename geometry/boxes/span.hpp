#pragma once

#include <algorithm>

#include "geometry/primitives.hpp"

namespace asv::geometry {

/// What a box covers of one axis.
struct Span {
    double low;
    double high;
};

constexpr Span x_span(const Box& box) {
    return {box.low.x, box.high.x};
}

constexpr Span y_span(const Box& box) {
    return {box.low.y, box.high.y};
}

/// What lies between two spans, or what they share.
constexpr Span between(const Span& a, const Span& b) {
    const double low = std::max(a.low, b.low);
    const double high = std::min(a.high, b.high);
    return {std::min(low, high), std::max(low, high)};
}

/// How far two spans are apart; negative where they overlap, by how much they do.
constexpr double apart(const Span& a, const Span& b) {
    return std::max(a.low, b.low) - std::min(a.high, b.high);
}

}  // namespace asv::geometry
