#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "geometry/boxes/grid_cover.hpp"

namespace asv::io {

/// More cells than this are no map that a planner could use: a byte each, three more while a PNG is
/// read.
inline constexpr std::uint64_t max_map_cells = 100'000'000;
inline constexpr std::uint64_t max_map_side = 1'000'000;

/// Walks over the words of a map and knows how to complain; name stands for the file in messages.
/// What is quoted of a file that is no text are not its bytes. The text and the name have to
/// outlive it.
class MapWords {
  public:
    /// comments: does '#' begin one, up to the end of the line? A byte order mark is stepped over.
    MapWords(std::string_view text, const std::string& name, bool comments);

    std::size_t offset() const { return at_; }
    /// The bytes from here on.
    std::string_view rest() const { return text_.substr(at_); }
    void skip(std::size_t bytes);

    /// ParseError at the next word, or right here.
    [[noreturn]] void fail(const std::string& expected);
    [[noreturn]] void fail_here(const std::string& expected) const;

    /// Steps over the next word when it is this one.
    bool take(std::string_view word);
    std::uint64_t number(const std::string& what, std::uint64_t low, std::uint64_t high);
    /// Steps over the next 0 or 1, which need not be a word of its own.
    std::uint8_t bit();
    /// Steps over the next character that is no blank, which has to be one of these; expected says
    /// so in the error.
    char one_of(std::string_view characters, const std::string& expected);
    bool at_end();

    /// An empty grid of this size. Throws ParseError for more than max_map_cells.
    geometry::Grid make_grid(std::uint64_t width, std::uint64_t height) const;

  private:
    std::string_view next() const;
    void skip_blanks();

    std::string_view text_;
    const std::string& name_;
    bool comments_;
    std::size_t at_ = 0;
};

/// Sets the cells from the top line down to what next() says.
template <class Next>
void fill(geometry::Grid& grid, const Next& next) {
    for (std::size_t y = grid.height; y-- > 0;)
        for (std::size_t x = 0; x < grid.width; ++x) grid.cells[y * grid.width + x] = next();
}

/// The brightness of a colour, ITU-R BT.601 luma.
inline double luma(double red, double green, double blue) {
    return 0.299 * red + 0.587 * green + 0.114 * blue;
}

}  // namespace asv::io
