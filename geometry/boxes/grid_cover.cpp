#include "geometry/boxes/grid_cover.hpp"

#include <utility>

namespace asv::geometry {

namespace {

std::size_t area(const CellRectangle& r) {
    return (r.right - r.left) * (r.top - r.bottom);
}

class Covering {
  public:
    explicit Covering(const Grid& grid)
        : grid_(grid), cell_(grid.cells.size()), right_(cell_.size()), up_(cell_.size()) {}

    std::vector<CellRectangle> run(std::size_t most) {
        for (std::size_t y = 0; y < grid_.height && chosen_.size() <= most; ++y) {
            for (std::size_t x = 0; x < grid_.width; ++x) {
                if (!grid_.occupied(x, y)) continue;
                const std::size_t i = y * grid_.width + x;
                const bool to_right = x + 1 < grid_.width && grid_.occupied(x + 1, y);
                const bool upwards = y + 1 < grid_.height && grid_.occupied(x, y + 1);
                if (to_right && !right_[i]) add({x, y, x + 2, y + 1});
                if (upwards && !up_[i]) add({x, y, x + 1, y + 2});
                if (!cell_[i]) add({x, y, x + 1, y + 1});
                if (chosen_.size() > most) break;
            }
        }
        return std::move(chosen_);
    }

  private:
    bool column_occupied(std::size_t x, const CellRectangle& r) const {
        for (std::size_t y = r.bottom; y < r.top; ++y)
            if (!grid_.occupied(x, y)) return false;
        return true;
    }

    bool row_occupied(std::size_t y, const CellRectangle& r) const {
        for (std::size_t x = r.left; x < r.right; ++x)
            if (!grid_.occupied(x, y)) return false;
        return true;
    }

    CellRectangle widened(CellRectangle r) const {
        while (r.left > 0 && column_occupied(r.left - 1, r)) --r.left;
        while (r.right < grid_.width && column_occupied(r.right, r)) ++r.right;
        return r;
    }

    CellRectangle heightened(CellRectangle r) const {
        while (r.bottom > 0 && row_occupied(r.bottom - 1, r)) --r.bottom;
        while (r.top < grid_.height && row_occupied(r.top, r)) ++r.top;
        return r;
    }

    /// Chooses a maximal rectangle around the seed and marks what it holds.
    void add(const CellRectangle& seed) {
        const CellRectangle flat = heightened(widened(seed)), steep = widened(heightened(seed));
        const CellRectangle& best = area(steep) > area(flat) ? steep : flat;
        for (std::size_t y = best.bottom; y < best.top; ++y) {
            for (std::size_t x = best.left; x < best.right; ++x) {
                const std::size_t i = y * grid_.width + x;
                cell_[i] = true;
                if (x + 1 < best.right) right_[i] = true;
                if (y + 1 < best.top) up_[i] = true;
            }
        }
        chosen_.push_back(best);
    }

    const Grid& grid_;
    std::vector<bool> cell_;        ///< is the cell in a chosen rectangle?
    std::vector<bool> right_, up_;  ///< together with its neighbour?
    std::vector<CellRectangle> chosen_;
};

}  // namespace

std::vector<CellRectangle> cover(const Grid& grid, std::size_t most) {
    return Covering(grid).run(most);
}

}  // namespace asv::geometry
