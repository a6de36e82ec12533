#include "geometry/boxes/dust_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace asv::geometry::detail {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// On average, so that few cells of evenly spread boxes need a further line.
constexpr double boxes_per_cell = 20;

/// No half side of a box in the grid is longer, in cells.
constexpr double longest_half_side = 1.0 / 16;

/// How many further lines there may be for each cell.
constexpr double max_further = 1.0 / 16;

Point half_sides(const Box& box) {
    return {box.high.x / 2 - box.low.x / 2, box.high.y / 2 - box.low.y / 2};
}

/// Where a point is, in cells from the low corner of the grid.
Point in_cells(const DustGrid& grid, const Point& point) {
    return {(point.x - grid.low.x) / grid.cell, (point.y - grid.low.y) / grid.cell};
}

/// The smallest box round some points.
struct Spread {
    Point low{infinity, infinity}, high{-infinity, -infinity};
    std::size_t count = 0;

    void include(const Point& point) {
        low = {std::min(low.x, point.x), std::min(low.y, point.y)};
        high = {std::max(high.x, point.x), std::max(high.y, point.y)};
        ++count;
    }
    double cells() const { return static_cast<double>(count) / boxes_per_cell; }
    /// The side of a cell.
    double cell() const { return std::sqrt((high.x - low.x) / cells() * (high.y - low.y)); }
};

/// Lays square cells over the points; false where no grid is worth having.
bool lay_out(DustGrid& grid, const Spread& spread) {
    if (spread.count <= BoxTree::max_without_leaves) return false;
    const auto& [low, high, count] = spread;
    const double largest = std::max({-low.x, -low.y, high.x, high.y});
    grid.low = low;
    grid.cell = spread.cell();
    // Searches reckon with rounding errors far below a step.
    if (!(grid.cell > largest * 0x1p-32 && grid.cell < infinity)) return false;
    const auto [columns, rows] = in_cells(grid, high);
    if ((columns + 1) * (rows + 1) > 2 * spread.cells()) return false;
    grid.columns = static_cast<std::uint32_t>(columns) + 1;
    grid.rows = static_cast<std::uint32_t>(rows) + 1;
    return true;
}

/// Divides the boxes that are not empty into small ones and others.
struct BySize {
    std::vector<Box> small, others;
    Spread spread;  ///< of the small ones' centres

    explicit BySize(std::span<const Box> boxes) {
        Spread all;
        for (const Box& box : boxes) {
            if (!is_empty(box)) all.include(centre(box));
        }
        const double longest = longest_half_side * all.cell();
        for (const Box& box : boxes) {
            if (is_empty(box)) continue;
            const auto [half_x, half_y] = half_sides(box);
            const bool is_small = std::max(half_x, half_y) <= longest;
            (is_small ? small : others).push_back(box);
            if (is_small) spread.include(centre(box));
        }
    }
};

/// The boxes cell by cell; cell c has those from begin[c] to begin[c + 1].
struct ByCell {
    std::vector<Box> boxes;
    std::vector<std::size_t> begin;

    std::span<const Box> of(std::size_t cell) const {
        return std::span(boxes).subspan(begin[cell], begin[cell + 1] - begin[cell]);
    }
};

ByCell sort_into_cells(const DustGrid& grid, std::span<const Box> boxes) {
    const auto cell_of = [&](const Box& box) {
        const auto [x, y] = in_cells(grid, centre(box));
        return static_cast<std::size_t>(y) * grid.columns + static_cast<std::size_t>(x);
    };
    ByCell sorted;
    sorted.begin.assign(std::size_t{grid.columns} * grid.rows + 1, 0);
    for (const Box& box : boxes) ++sorted.begin[cell_of(box) + 1];
    std::partial_sum(sorted.begin.begin(), sorted.begin.end(), sorted.begin.begin());
    sorted.boxes.resize(boxes.size());
    std::vector<std::size_t> next = sorted.begin;
    for (const Box& box : boxes) sorted.boxes[next[cell_of(box)]++] = box;
    return sorted;
}

bool few_further_lines(const ByCell& sorted) {
    const std::size_t cells = sorted.begin.size() - 1;
    std::size_t further = 0;
    for (std::size_t c = 0; c < cells; ++c) {
        const std::size_t count = sorted.of(c).size();
        further += count == 0 ? 0 : (count - 1) / DustLine::max_boxes;
    }
    return static_cast<double>(further) <= max_further * static_cast<double>(cells);
}

/// A line and the boxes of its cell that are still to come.
struct Overflow {
    std::size_t line;
    std::span<const Box> boxes;
};

/// Adds a line with as many of the boxes as it holds; the others overflow.
void add_line(DustGrid& grid, std::span<const Box> boxes, std::vector<Overflow>& overflow) {
    DustLine line{};
    const std::size_t count = std::min<std::size_t>(boxes.size(), DustLine::max_boxes);
    for (std::size_t lane = 0; lane < count; ++lane) {
        const auto [x, y] = in_cells(grid, centre(boxes[lane]));
        line.x[lane] = static_cast<std::uint8_t>((x - std::floor(x)) * DustLine::steps + 0.5);
        line.y[lane] = static_cast<std::uint8_t>((y - std::floor(y)) * DustLine::steps + 0.5);
        const auto [half_x, half_y] = half_sides(boxes[lane]);
        grid.half_x = std::max(grid.half_x, half_x);
        grid.half_y = std::max(grid.half_y, half_y);
        grid.boxes.push_back({boxes[lane]});
    }
    if (count < boxes.size()) overflow.push_back({grid.lines.size(), boxes.subspan(count)});
    grid.lines.push_back(line);
    grid.further.push_back(0);
    grid.first.push_back(static_cast<std::uint32_t>(grid.boxes.size()));
}

void add_lines(DustGrid& grid, const ByCell& sorted) {
    const std::size_t cells = sorted.begin.size() - 1;
    grid.lines.reserve(cells);
    grid.boxes.reserve(sorted.boxes.size());
    grid.first = {0};
    std::vector<Overflow> overflow;
    for (std::size_t c = 0; c < cells; ++c) add_line(grid, sorted.of(c), overflow);
    for (std::size_t i = 0; i < overflow.size(); ++i) {
        const auto [line, rest] = overflow[i];
        grid.lines[line].set_goes_on();
        grid.further[line] = static_cast<std::uint32_t>(grid.lines.size());
        add_line(grid, rest, overflow);
    }
}

}  // namespace

DustGrid build_dust_grid(std::span<const Box> boxes) {
    if (boxes.size() <= BoxTree::max_without_leaves) return {};
    const BySize by_size(boxes);
    DustGrid grid;
    if (by_size.others.size() > by_size.small.size()) return {};
    if (!lay_out(grid, by_size.spread)) return {};
    const ByCell sorted = sort_into_cells(grid, by_size.small);
    if (!few_further_lines(sorted)) return {};
    add_lines(grid, sorted);
    grid.others = build_box_tree(by_size.others);
    return grid;
}

}  // namespace asv::geometry::detail
