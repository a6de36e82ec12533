#include "asv/core/generate/carve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace asv::core {

using geometry::Box;

namespace {

double rounded(double value) {
    return std::round(value * 1e9) / 1e9;
}

Box rounded(const Box& box) {
    return {{rounded(box.low.x), rounded(box.low.y)}, {rounded(box.high.x), rounded(box.high.y)}};
}

/// Which cells of the grid through all sides are solid.
class CellGrid {
  public:
    CellGrid(const Box& solid, std::span<const Box> passages) {
        xs_ = {solid.low.x, solid.high.x};
        ys_ = {solid.low.y, solid.high.y};
        for (const Box& passage : passages) {
            add(xs_, passage.low.x, passage.high.x, solid.low.x, solid.high.x);
            add(ys_, passage.low.y, passage.high.y, solid.low.y, solid.high.y);
        }
        sort_unique(xs_);
        sort_unique(ys_);
        solid_.assign(columns() * rows(), true);
        for (const Box& passage : passages) cut(passage);
    }

    std::size_t columns() const { return xs_.size() - 1; }
    std::size_t rows() const { return ys_.size() - 1; }
    bool solid(std::size_t column, std::size_t row) const {
        return solid_[row * columns() + column];
    }
    Box box(std::size_t first_column, std::size_t first_row, std::size_t last_column,
            std::size_t last_row) const {
        return {{xs_[first_column], ys_[first_row]}, {xs_[last_column + 1], ys_[last_row + 1]}};
    }

  private:
    static void add(std::vector<double>& values, double low, double high, double least,
                    double most) {
        values.push_back(std::clamp(low, least, most));
        values.push_back(std::clamp(high, least, most));
    }
    static void sort_unique(std::vector<double>& values) {
        std::sort(values.begin(), values.end());
        values.erase(std::unique(values.begin(), values.end()), values.end());
    }
    void cut(const Box& passage) {
        for (std::size_t row = 0; row < rows(); ++row) {
            if (ys_[row] < passage.low.y || ys_[row + 1] > passage.high.y) continue;
            for (std::size_t column = 0; column < columns(); ++column) {
                if (xs_[column] >= passage.low.x && xs_[column + 1] <= passage.high.x)
                    solid_[row * columns() + column] = false;
            }
        }
    }

    std::vector<double> xs_, ys_;
    std::vector<bool> solid_;
};

/// For every maximal run of solid cells in a line, the box that grows from it across the lines as
/// far as it stays solid. solid(along, across) says whether a cell is; emit takes the four indices.
template <class Solid, class Emit>
void grow_runs(std::size_t length, std::size_t lines, Solid&& solid, Emit&& emit) {
    for (std::size_t line = 0; line < lines; ++line) {
        std::size_t first = 0;
        while (first < length) {
            if (!solid(first, line)) {
                ++first;
                continue;
            }
            std::size_t last = first;
            while (last + 1 < length && solid(last + 1, line)) ++last;
            const auto whole_run = [&](std::size_t other) {
                for (std::size_t i = first; i <= last; ++i) {
                    if (!solid(i, other)) return false;
                }
                return true;
            };
            std::size_t low = line;
            std::size_t high = line;
            while (low > 0 && whole_run(low - 1)) --low;
            while (high + 1 < lines && whole_run(high + 1)) ++high;
            emit(first, last, low, high);
            first = last + 1;
        }
    }
}

auto key(const Box& box) {
    return std::tie(box.low.x, box.low.y, box.high.x, box.high.y);
}

bool contains(const Box& outer, const Box& inner) {
    return outer.low.x <= inner.low.x && outer.low.y <= inner.low.y &&
           outer.high.x >= inner.high.x && outer.high.y >= inner.high.y;
}

}  // namespace

std::vector<Box> carve(const Box& solid, std::span<const Box> passages) {
    std::vector<Box> cuts;
    for (const Box& passage : passages) cuts.push_back(rounded(passage));
    const CellGrid grid(rounded(solid), cuts);
    std::vector<Box> boxes;
    grow_runs(
        grid.columns(), grid.rows(), [&](auto x, auto y) { return grid.solid(x, y); },
        [&](auto x0, auto x1, auto y0, auto y1) { boxes.push_back(grid.box(x0, y0, x1, y1)); });
    grow_runs(
        grid.rows(), grid.columns(), [&](auto y, auto x) { return grid.solid(x, y); },
        [&](auto y0, auto y1, auto x0, auto x1) { boxes.push_back(grid.box(x0, y0, x1, y1)); });
    std::sort(boxes.begin(), boxes.end(),
              [](const Box& a, const Box& b) { return key(a) < key(b); });
    boxes.erase(std::unique(boxes.begin(), boxes.end()), boxes.end());
    const std::vector<Box> all = boxes;
    std::erase_if(boxes, [&](const Box& box) {
        return std::any_of(all.begin(), all.end(), [&](const Box& other) {
            return !(other == box) && contains(other, box);
        });
    });
    return boxes;
}

}  // namespace asv::core
