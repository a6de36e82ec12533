#include "io/player/packing.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>

namespace asv::io {

namespace {

constexpr std::string_view alphabet =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

constexpr double finest_unit = 1e-10;

template <class Bits, class Number>
std::string pack(std::span<const Number> numbers) {
    static_assert(sizeof(Bits) == sizeof(Number));
    std::string bytes;
    bytes.reserve(numbers.size() * sizeof(Bits));
    for (const Number number : numbers) {
        const auto bits = std::bit_cast<Bits>(number);
        for (std::size_t i = 0; i < sizeof(Bits); ++i) {
            bytes += static_cast<char>((bits >> (8 * i)) & 0xFF);
        }
    }
    return base64(bytes);
}

void append_zigzag(std::string& bytes, std::int64_t number) {
    // The shift of a negative number copies its sign: all bits are turned over.
    auto code =
        (static_cast<std::uint64_t>(number) << 1) ^ static_cast<std::uint64_t>(number >> 63);
    while (code >= 128) {
        bytes += static_cast<char>((code & 127) | 128);
        code >>= 7;
    }
    bytes += static_cast<char>(code);
}

std::string bytes_of(std::string_view text) {
    std::string bytes;
    std::uint32_t window = 0;
    int bits = 0;
    for (const char c : text.substr(0, text.find('='))) {
        const std::size_t digit = alphabet.find(c);
        if (digit == std::string_view::npos) throw std::invalid_argument("text: not base64");
        window = (window << 6 | static_cast<std::uint32_t>(digit)) & 0xFFFFFF;
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes += static_cast<char>((window >> bits) & 0xFF);
    }
    return bytes;
}

}  // namespace

std::string base64(std::string_view bytes) {
    std::string text;
    text.reserve(base64_size(bytes.size()));
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t k) -> std::uint32_t {
            return i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U;
        };
        const std::uint32_t group = byte(0) << 16 | byte(1) << 8 | byte(2);
        text += alphabet[group >> 18 & 63];
        text += alphabet[group >> 12 & 63];
        text += i + 1 < bytes.size() ? alphabet[group >> 6 & 63] : '=';
        text += i + 2 < bytes.size() ? alphabet[group & 63] : '=';
    }
    return text;
}

std::string pack_doubles(std::span<const double> numbers) {
    return pack<std::uint64_t>(numbers);
}

std::string pack_floats(std::span<const float> numbers) {
    return pack<std::uint32_t>(numbers);
}

std::string pack_integers(std::span<const std::int32_t> numbers) {
    return pack<std::uint32_t>(numbers);
}

PackedTable pack_table(std::span<const double> numbers, std::size_t columns) {
    double greatest = 1;
    for (const double number : numbers) greatest = std::max(greatest, std::abs(number));
    const double unit = finest_unit * greatest;
    std::string bytes;
    for (std::size_t column = 0; column < columns; ++column) {
        std::int64_t value = 0;
        std::int64_t difference = 0;
        for (std::size_t i = column; i < numbers.size(); i += columns) {
            const auto next = static_cast<std::int64_t>(std::llround(numbers[i] / unit));
            append_zigzag(bytes, next - value - difference);
            difference = next - value;
            value = next;
        }
    }
    return {unit, base64(bytes)};
}

std::vector<double> unpack_table(const PackedTable& table, std::size_t rows, std::size_t columns) {
    const std::string bytes = bytes_of(table.text);
    std::vector<double> numbers(rows * columns);
    std::size_t at = 0;
    for (std::size_t column = 0; column < columns; ++column) {
        std::int64_t value = 0;
        std::int64_t difference = 0;
        for (std::size_t row = 0; row < rows; ++row) {
            std::uint64_t code = 0;
            for (int shift = 0;; shift += 7) {
                if (at == bytes.size() || shift > 63) {
                    throw std::invalid_argument("table: not a packed table of this shape");
                }
                const auto byte = static_cast<unsigned char>(bytes[at++]);
                code |= static_cast<std::uint64_t>(byte & 127) << shift;
                if (byte < 128) break;
            }
            difference +=
                static_cast<std::int64_t>(code >> 1) ^ -static_cast<std::int64_t>(code & 1);
            value += difference;
            numbers[row * columns + column] = static_cast<double>(value) * table.unit;
        }
    }
    if (at != bytes.size()) throw std::invalid_argument("table: not a packed table of this shape");
    return numbers;
}

}  // namespace asv::io
