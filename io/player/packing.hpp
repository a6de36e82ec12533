#pragma once

#include <concepts>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Numbers as short texts that a script unpacks quickly.
namespace asv::io {

/// RFC 4648, section 4, with padding.
std::string base64(std::string_view bytes);

/// How long the base64 of so many bytes is.
constexpr std::size_t base64_size(std::size_t bytes) {
    return (bytes + 2) / 3 * 4;
}

/// Base64 of the numbers' bytes, the lowest byte of each first, whatever the machine.
std::string pack_doubles(std::span<const double> numbers);
std::string pack_floats(std::span<const float> numbers);
std::string pack_integers(std::span<const std::int32_t> numbers);

/// A table of numbers that change little from row to row, as multiples of one unit.
struct PackedTable {
    double unit = 1;   ///< the rounding error of a number is at most half of it
    std::string text;  ///< base64 of the packed bytes
};

/// Packs a table column by column: each number as a multiple of the unit, of these the second
/// differences down the column, of these the zigzag code (0, -1, 1, -2, ...) in groups of 7 bits,
/// lowest first, the highest bit set where more follow. The unit is 1e-10 as long as no number is
/// beyond 1, and grows in proportion to the greatest. Smooth paths need 2 to 3 bytes a number.
/// Precondition: finite numbers, size a multiple of columns > 0.
PackedTable pack_table(std::span<const double> numbers, std::size_t columns);

/// The inverse, for checking what a script will see. Throws std::invalid_argument when the text is
/// not a packed table of this shape.
std::vector<double> unpack_table(const PackedTable& table, std::size_t rows, std::size_t columns);

}  // namespace asv::io
