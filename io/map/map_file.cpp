#include "io/map/map_file.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <vector>

#include <png.h>

#include "io/text/atomic_file.hpp"
#include "io/text/json_place.hpp"
#include "io/text/parse_error.hpp"

namespace asv::io {

namespace {

using geometry::Grid;

/// More cells than this are no map that a planner could use.
constexpr std::uint64_t max_cells = 100'000'000;

bool is_blank(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/// Walks over the words of a text and knows how to complain.
class Words {
  public:
    Words(std::string_view text, const std::string& name, bool comments)
        : text_(text), name_(name), comments_(comments) {}

    std::size_t offset() const { return at_; }
    void skip(std::size_t bytes) { at_ = std::min(at_ + bytes, text_.size()); }

    [[noreturn]] void fail(const std::string& expected) {
        skip_blanks();
        fail_here(expected);
    }

    [[noreturn]] void fail_here(const std::string& expected) const {
        const TextPlace place = place_of_offset(text_, at_);
        const std::string_view found = next();
        throw ParseError(
            name_, place.line, place.column, expected,
            found.empty() ? "the end of the file" : "'" + std::string(found.substr(0, 20)) + "'");
    }

    /// Steps over the next word when it is this one.
    bool take(std::string_view word) {
        skip_blanks();
        if (next() != word) return false;
        at_ += word.size();
        return true;
    }

    std::uint64_t number(const std::string& what, std::uint64_t low, std::uint64_t high) {
        skip_blanks();
        const std::string_view digits = next();
        std::uint64_t value = 0;
        const auto [end, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), value);
        if (error != std::errc{} || end != digits.data() + digits.size() || value < low ||
            value > high)
            fail_here(what + " (a whole number from " + std::to_string(low) + " to " +
                      std::to_string(high) + ")");
        at_ += digits.size();
        return value;
    }

    /// The next character that is no blank, or none at the end.
    std::optional<char> character() {
        skip_blanks();
        if (at_ >= text_.size()) return std::nullopt;
        return text_[at_++];
    }
    void back() { --at_; }

  private:
    std::string_view next() const {
        std::size_t end = at_;
        while (end < text_.size() && !is_blank(text_[end])) ++end;
        return text_.substr(at_, end - at_);
    }

    void skip_blanks() {
        while (at_ < text_.size() && (is_blank(text_[at_]) || (comments_ && text_[at_] == '#'))) {
            const bool comment = text_[at_] == '#';
            at_ = comment ? std::min(text_.find('\n', at_), text_.size()) : at_ + 1;
        }
    }

    std::string_view text_;
    const std::string& name_;
    bool comments_;
    std::size_t at_ = 0;
};

/// An empty grid of this size, where the content can fill it.
Grid make_grid(std::uint64_t width, std::uint64_t height, Words& words) {
    if (width * height > max_cells)
        words.fail_here("at most " + std::to_string(max_cells) + " cells");
    Grid grid{static_cast<std::size_t>(width), static_cast<std::size_t>(height)};
    grid.cells.resize(grid.width * grid.height);
    return grid;
}

/// Sets the cells from the top line down to what next() says.
template <class Next>
void fill(Grid& grid, const Next& next) {
    for (std::size_t y = grid.height; y-- > 0;)
        for (std::size_t x = 0; x < grid.width; ++x) grid.cells[y * grid.width + x] = next();
}

constexpr std::uint64_t longest_side = 1'000'000;

Grid parse_pgm(std::string_view content, const std::string& name, double threshold) {
    const bool binary = content[1] == '5';
    Words words(content, name, true);
    words.skip(2);
    const std::uint64_t width = words.number("the width", 1, longest_side);
    const std::uint64_t height = words.number("the height", 1, longest_side);
    const std::uint64_t white = words.number("the value of white", 1, 65535);
    const auto is_dark = [&](std::uint64_t value) -> std::uint8_t {
        return static_cast<double>(value) * 255 <= threshold * static_cast<double>(white);
    };
    if (!binary) {
        if (width * height > content.size()) words.fail("more pixels");
        Grid grid = make_grid(width, height, words);
        fill(grid, [&] { return is_dark(words.number("a pixel", 0, white)); });
        return grid;
    }
    words.skip(1);
    const std::size_t bytes = white > 255 ? 2 : 1;
    if (width * height > (content.size() - words.offset()) / bytes) {
        words.skip(content.size());
        words.fail_here(std::to_string(width * height * bytes) + " bytes of pixels");
    }
    Grid grid = make_grid(width, height, words);
    std::size_t at = words.offset();
    fill(grid, [&] {
        std::uint64_t value = static_cast<unsigned char>(content[at++]);
        if (bytes == 2) value = value << 8 | static_cast<unsigned char>(content[at++]);
        return is_dark(value);
    });
    return grid;
}

/// A PNG picture as libpng reads it; what it holds is given back on every way out.
struct PngReader {
    png_image image{};

    PngReader() { image.version = PNG_IMAGE_VERSION; }
    ~PngReader() { png_image_free(&image); }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
};

Grid parse_png(std::string_view content, const std::string& name, double threshold) {
    PngReader reader;
    const auto require = [&](int done) {
        if (done == 0) throw ParseError(name, 1, 1, "a PNG picture", reader.image.message);
    };
    require(png_image_begin_read_from_memory(&reader.image, content.data(), content.size()));
    Words words(content, name, false);
    Grid grid = make_grid(reader.image.width, reader.image.height, words);
    // 8 bits for each colour, whatever it had, on white.
    reader.image.format = PNG_FORMAT_RGB;
    const png_color white{255, 255, 255};
    std::vector<unsigned char> pixels(PNG_IMAGE_SIZE(reader.image));
    require(png_image_finish_read(&reader.image, &white, pixels.data(), 0, nullptr));
    for (std::size_t y = 0; y < grid.height; ++y) {
        for (std::size_t x = 0; x < grid.width; ++x) {
            const unsigned char* pixel =
                pixels.data() + 3 * ((grid.height - 1 - y) * grid.width + x);
            // ITU-R BT.601 luma.
            const double luma = 0.299 * pixel[0] + 0.587 * pixel[1] + 0.114 * pixel[2];
            grid.cells[y * grid.width + x] = luma <= threshold;
        }
    }
    return grid;
}

Grid parse_text_grid(std::string_view content, const std::string& name) {
    Words words(content, name, false);
    std::uint64_t width = 0, height = 0;
    while (width == 0 || height == 0) {
        if (width == 0 && words.take("width")) {
            width = words.number("the width", 1, longest_side);
        } else if (height == 0 && words.take("height")) {
            height = words.number("the height", 1, longest_side);
        } else {
            words.fail("a PGM or PNG picture, or a grid that begins with 'height H' and 'width W'");
        }
    }
    if (width * height > content.size())
        words.fail(std::to_string(width * height) + " digits 0 or 1");
    Grid grid = make_grid(width, height, words);
    fill(grid, [&]() -> std::uint8_t {
        const std::optional<char> digit = words.character();
        if (digit && (*digit == '0' || *digit == '1')) return *digit == '1';
        if (digit) words.back();
        words.fail_here("0 or 1");
    });
    if (words.character()) {
        words.back();
        words.fail_here("the end of the file after " + std::to_string(width * height) + " digits");
    }
    return grid;
}

}  // namespace

Grid parse_map(std::string_view content, const std::string& name, double threshold) {
    if (content.starts_with("P2") || content.starts_with("P5"))
        return parse_pgm(content, name, threshold);
    if (content.starts_with("\x89PNG")) return parse_png(content, name, threshold);
    return parse_text_grid(content, name);
}

Grid read_map(const std::filesystem::path& file, double threshold) {
    return parse_map(read_file(file), file.string(), threshold);
}

}  // namespace asv::io
