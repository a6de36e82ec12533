#include "core/generate/carve.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

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

/// Calls emit(first, last) for every maximal run of true values.
template <class Emit>
void for_each_run(const std::vector<bool>& values, Emit&& emit) {
    std::size_t first = 0;
    while (first < values.size()) {
        std::size_t last = first;
        while (last < values.size() && values[last]) ++last;
        if (last > first) emit(first, last - 1);
        first = last + 1;
    }
}

}  // namespace

std::vector<Box> carve(const Box& solid, std::span<const Box> passages) {
    std::vector<Box> cuts;
    for (const Box& passage : passages) cuts.push_back(rounded(passage));
    const CellGrid grid(rounded(solid), cuts);
    const auto solid_run = [&](std::size_t first, std::size_t last, std::size_t row) {
        for (std::size_t column = first; column <= last; ++column) {
            if (!grid.solid(column, row)) return false;
        }
        return true;
    };
    std::vector<Box> boxes;
    for (std::size_t low = 0; low < grid.rows(); ++low) {
        // Columns that are solid from row low up to row high.
        std::vector<bool> open(grid.columns(), true);
        for (std::size_t high = low; high < grid.rows(); ++high) {
            for (std::size_t column = 0; column < grid.columns(); ++column)
                open[column] = open[column] && grid.solid(column, high);
            for_each_run(open, [&](std::size_t first, std::size_t last) {
                const bool grows = (low > 0 && solid_run(first, last, low - 1)) ||
                                   (high + 1 < grid.rows() && solid_run(first, last, high + 1));
                if (!grows) boxes.push_back(grid.box(first, low, last, high));
            });
        }
    }
    return boxes;
}

}  // namespace asv::core
