#include "io/map/anymap.hpp"

#include <cstddef>
#include <cstdint>

#include "io/map/words.hpp"

namespace asv::io {
namespace {

using geometry::Grid;

constexpr std::uint64_t greatest_white = 65535;

/// What the digit behind the P says, and what stands behind it.
struct Header {
    bool binary;
    std::size_t samples;  ///< for each pixel: 3 for colours
    std::uint64_t width, height, white;
};

Header read_header(MapWords& words, char kind) {
    words.skip(2);
    Header header{};
    header.binary = kind >= '4';
    header.samples = kind == '3' || kind == '6' ? 3 : 1;
    header.width = words.number("the width", 1, max_map_side);
    header.height = words.number("the height", 1, max_map_side);
    const bool bits = kind == '1' || kind == '4';
    header.white = bits ? 1 : words.number("the value of white", 1, greatest_white);
    // One blank ends the header of a binary picture.
    if (header.binary) words.skip(1);
    return header;
}

/// What of a picture in black and white is occupied.
struct BitGreys {
    bool black, white;

    std::uint8_t of(bool is_black) const { return is_black ? black : white; }
};

/// Complains unless there are so many bytes; before memory is taken for what they would fill.
void require_bytes(MapWords& words, std::uint64_t bytes, const std::string& what) {
    if (bytes <= words.rest().size()) return;
    words.skip(words.rest().size());
    words.fail_here(what);
}

/// Black and white: rows of bits, each row filled up to a whole byte.
Grid read_packed_bits(MapWords& words, const Header& header, const BitGreys& occupied) {
    const std::uint64_t row = (header.width + 7) / 8;
    require_bytes(words, row * header.height,
                  std::to_string(row * header.height) + " bytes of pixels");
    Grid grid = words.make_grid(header.width, header.height);
    const std::string_view bytes = words.rest();
    std::size_t x = 0, line = 0;
    fill(grid, [&]() -> std::uint8_t {
        const auto byte = static_cast<unsigned char>(bytes[line * row + x / 8]);
        const bool black = (byte >> (7 - x % 8) & 1U) != 0;
        if (++x == header.width) {
            x = 0;
            ++line;
        }
        return occupied.of(black);
    });
    return grid;
}

/// next() gives one sample after the other.
template <class Next>
void fill_with_samples(Grid& grid, const Header& header, const OccupiedGreys& greys,
                       const Next& next) {
    const auto white = static_cast<double>(header.white);
    fill(grid, [&]() -> std::uint8_t {
        if (header.samples == 1) return greys.hold(static_cast<double>(next()) * 255, white);
        const auto red = static_cast<double>(next());
        const auto green = static_cast<double>(next());
        return greys.hold(luma(red, green, static_cast<double>(next())) * 255, white);
    });
}

Grid read_samples(MapWords& words, const Header& header, const OccupiedGreys& greys) {
    const std::uint64_t samples = header.width * header.height * header.samples;
    if (!header.binary) {
        if (samples > words.rest().size()) words.fail("more pixels");
        Grid grid = words.make_grid(header.width, header.height);
        fill_with_samples(grid, header, greys,
                          [&] { return words.number("a pixel", 0, header.white); });
        return grid;
    }
    const std::size_t size = header.white > 255 ? 2 : 1;
    require_bytes(words, samples * size, std::to_string(samples * size) + " bytes of pixels");
    Grid grid = words.make_grid(header.width, header.height);
    const std::string_view bytes = words.rest();
    std::size_t at = 0;
    fill_with_samples(grid, header, greys, [&] {
        std::uint64_t value = static_cast<unsigned char>(bytes[at++]);
        if (size == 2) value = value << 8 | static_cast<unsigned char>(bytes[at++]);
        return value;
    });
    return grid;
}

}  // namespace

bool is_anymap(std::string_view content) {
    return content.size() > 2 && content[0] == 'P' && content[1] >= '1' && content[1] <= '6';
}

Grid parse_anymap(std::string_view content, const std::string& name, const OccupiedGreys& greys) {
    const char kind = content[1];
    MapWords words(content, name, true);
    const Header header = read_header(words, kind);
    const BitGreys occupied{greys.hold(0), greys.hold(255)};
    if (kind == '4') return read_packed_bits(words, header, occupied);
    if (kind != '1') return read_samples(words, header, greys);
    if (header.width * header.height > words.rest().size()) words.fail("more pixels");
    Grid grid = words.make_grid(header.width, header.height);
    fill(grid, [&]() -> std::uint8_t { return occupied.of(words.bit() != 0); });
    return grid;
}

}  // namespace asv::io
