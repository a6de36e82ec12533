#include "io/map/map_file.hpp"

#include "io/map/anymap.hpp"
#include "io/map/png_map.hpp"
#include "io/map/words.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/parse_error.hpp"

namespace asv::io {

namespace {

using geometry::Grid;

/// The digits up to the end of the file.
Grid read_digits(MapWords& words, std::uint64_t width, std::uint64_t height) {
    if (width * height > words.rest().size())
        words.fail(std::to_string(width * height) + " digits 0 or 1");
    Grid grid = words.make_grid(width, height);
    fill(grid, [&] { return words.bit(); });
    if (!words.at_end())
        words.fail_here("the end of the file after " + std::to_string(width * height) + " digits");
    return grid;
}

/// A grid without a header: as many digits in each line.
Grid parse_bare_grid(MapWords& words) {
    const std::string_view text = words.rest();
    std::uint64_t width = 0, height = 0, digits = 0;
    for (std::size_t i = 0; i <= text.size(); ++i) {
        if (i < text.size() && (text[i] == '0' || text[i] == '1')) ++digits;
        const bool line_ends = i == text.size() || text[i] == '\n' || text[i] == '\r';
        if (!line_ends || digits == 0) continue;
        if (height++ == 0) width = digits;
        if (digits != width) {
            words.skip(i);
            words.fail_here(std::to_string(width) + " digits in each line, as in the first one");
        }
        digits = 0;
    }
    return read_digits(words, width, height);
}

struct GridSize {
    std::uint64_t width = 0, height = 0;
};

/// "height H" and "width W" in any order.
GridSize read_size(MapWords& words, const std::string& expected) {
    GridSize size;
    while (size.width == 0 || size.height == 0) {
        if (size.width == 0 && words.take("width")) {
            size.width = words.number("the width", 1, max_map_side);
        } else if (size.height == 0 && words.take("height")) {
            size.height = words.number("the height", 1, max_map_side);
        } else {
            words.fail(expected);
        }
    }
    return size;
}

/// What follows the word "type" in a map of the benchmarks for pathfinding on grids (Sturtevant,
/// 2012), as MovingAI has them. Free is what one walks on: ground (. and G) and swamp (S); water
/// (W) is not, nor are trees (T) and what is out of bounds (@ and O).
Grid parse_benchmark_grid(MapWords& words) {
    if (!words.take("octile"))
        words.fail("'octile', the type of a map of 'height H' and 'width W'");
    const GridSize size = read_size(words, "'height H' and 'width W'");
    if (!words.take("map")) words.fail("'map' before the lines of the map");
    if (size.width * size.height > words.rest().size())
        words.fail(std::to_string(size.width * size.height) + " cells");
    Grid grid = words.make_grid(size.width, size.height);
    fill(grid, [&]() -> std::uint8_t {
        const char cell = words.one_of(".GSWT@O", "a cell (one of . G S W T @ O)");
        return cell == 'W' || cell == 'T' || cell == '@' || cell == 'O';
    });
    if (!words.at_end()) words.fail_here("the end of the file after the last cell");
    return grid;
}

Grid parse_text_grid(std::string_view content, const std::string& name) {
    MapWords words(content, name, false);
    if (!words.at_end() && (words.rest()[0] == '0' || words.rest()[0] == '1'))
        return parse_bare_grid(words);
    if (words.take("type")) return parse_benchmark_grid(words);
    const GridSize size = read_size(
        words,
        "a picture (PBM, PGM, PPM or PNG), lines of digits 0 and 1, 'height H' and 'width W' "
        "before them, or 'type octile' before those");
    return read_digits(words, size.width, size.height);
}

}  // namespace

Grid parse_map(std::string_view content, const std::string& name, const OccupiedGreys& greys) {
    if (is_anymap(content)) return parse_anymap(content, name, greys);
    if (is_png(content)) return parse_png(content, name, greys);
    return parse_text_grid(content, name);
}

Grid read_map(const std::filesystem::path& file, const OccupiedGreys& greys) {
    return parse_map(read_regular_file(file), file.string(), greys);
}

}  // namespace asv::io
