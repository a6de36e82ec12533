#include "core/certificate_check/plane.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace asv::core::certificate_check {

namespace {

/// Coordinates that divide an axis: interval 0 before the first one, 1 the first one itself,
/// interval 2 between it and the next one, and so on.
class Axis {
  public:
    explicit Axis(std::vector<Number> lines) : lines_(std::move(lines)) {
        std::sort(lines_.begin(), lines_.end());
        lines_.erase(std::unique(lines_.begin(), lines_.end()), lines_.end());
    }

    std::size_t size() const { return 2 * lines_.size() + 1; }

    std::size_t position(const Number& value) const {
        const auto next = std::lower_bound(lines_.begin(), lines_.end(), value);
        const auto before = static_cast<std::size_t>(next - lines_.begin());
        return 2 * before + (next != lines_.end() && *next == value ? 1 : 0);
    }

  private:
    std::vector<Number> lines_;
};

std::vector<Rectangle> with(std::vector<Rectangle> walls, const std::optional<Rectangle>& bounds) {
    if (bounds) walls.push_back(*bounds);
    return walls;
}

Axis axis(const std::vector<Rectangle>& rectangles, Number Rectangle::*low,
          Number Rectangle::*high) {
    std::vector<Number> lines;
    for (const Rectangle& rectangle : rectangles) {
        lines.push_back(rectangle.*low);
        lines.push_back(rectangle.*high);
    }
    return Axis(std::move(lines));
}

/// The lines, the crossings and what is between them. What is left free by closed walls is open, so
/// that two neighbours that are both free are connected, and nothing else is.
class Grid {
  public:
    Grid(const std::vector<Rectangle>& walls, const std::optional<Rectangle>& bounds)
        : x_(axis(with(walls, bounds), &Rectangle::left, &Rectangle::right)),
          y_(axis(with(walls, bounds), &Rectangle::bottom, &Rectangle::top)),
          closed_(x_.size() * y_.size(), bounds.has_value()) {
        if (bounds) fill(*bounds, false);
        for (const Rectangle& wall : walls) fill(wall, true);
    }

    Connection connection(const Place& from, const Place& to) {
        const std::size_t start = cell(from), goal = cell(to);
        if (closed_[start] || closed_[goal]) return Connection::in_a_wall;
        std::vector<std::size_t> open{start};
        closed_[start] = true;
        const auto spread = [&](std::size_t next) {
            if (closed_[next]) return;
            closed_[next] = true;
            open.push_back(next);
        };
        while (!open.empty()) {
            const std::size_t here = open.back();
            open.pop_back();
            const std::size_t x = here / y_.size(), y = here % y_.size();
            if (x > 0) spread(here - y_.size());
            if (x + 1 < x_.size()) spread(here + y_.size());
            if (y > 0) spread(here - 1);
            if (y + 1 < y_.size()) spread(here + 1);
        }
        return closed_[goal] ? Connection::connected : Connection::separated;
    }

  private:
    std::size_t cell(const Place& place) const {
        return x_.position(place.x) * y_.size() + y_.position(place.y);
    }

    void fill(const Rectangle& rectangle, bool closed) {
        const std::size_t low = y_.position(rectangle.bottom);
        const std::size_t high = y_.position(rectangle.top);
        for (std::size_t x = x_.position(rectangle.left); x <= x_.position(rectangle.right); ++x)
            for (std::size_t y = low; y <= high; ++y) closed_[x * y_.size() + y] = closed;
    }

    Axis x_, y_;
    std::vector<bool> closed_;
};

}  // namespace

Connection connection(const std::vector<Rectangle>& walls, const std::optional<Rectangle>& bounds,
                      const Place& from, const Place& to) {
    return Grid(walls, bounds).connection(from, to);
}

}  // namespace asv::core::certificate_check
