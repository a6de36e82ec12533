#pragma once

#include <cstdint>
#include <span>

namespace asv::geometry::batch {

/// Many segments, coordinate by coordinate. All spans have one length.
struct Segments {
    std::span<const double> a_x, a_y, b_x, b_y;
};

/// Many boxes, likewise.
struct Boxes {
    std::span<const double> low_x, low_y, high_x, high_y;
};

/// Writes 1 to result[i] where closed segment i and closed box i share a point (touching counts),
/// and 0 elsewhere: exactly geometry::meets, several pairs at a time, on every processor.
/// Preconditions: finite coordinates; as many segments as boxes as results.
void meets(const Segments& segments, const Boxes& boxes, std::span<std::uint8_t> result) noexcept;

}  // namespace asv::geometry::batch
