#include "tests/kit/batch/batch_worlds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/benchmark/scalar_chain.hpp"
#include "geometry/boxes/box_index.hpp"

namespace asv::test {

using geometry::Box;
using geometry::Point;

std::vector<Box> dust(std::size_t count, Random& random) {
    const double side = std::min(0.1, 0.3 / static_cast<double>(count));
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < count; ++i) {
        const Point low{random.uniform(0, 1 - side), random.uniform(0, 1 - side)};
        boxes.push_back({low, {low.x + side, low.y + side}});
    }
    return boxes;
}

std::vector<Box> grid_map(std::size_t count, Random& random) {
    // About a quarter of the cells are occupied.
    const auto cells =
        static_cast<std::size_t>(std::ceil(std::sqrt(4.5 * static_cast<double>(count))));
    const double cell = 1 / static_cast<double>(cells);
    std::vector<bool> occupied(cells * cells);
    std::vector<Box> boxes;
    while (boxes.size() < count) {
        const Point centre{random.uniform(0, 1), random.uniform(0, 1)};
        const double radius = random.uniform(0.01, 0.05);
        const auto first = [&](double v) {
            return static_cast<std::size_t>(std::max(0.0, (v - radius) / cell));
        };
        const auto last = [&](double v) {
            return std::min(cells, static_cast<std::size_t>((v + radius) / cell) + 1);
        };
        for (std::size_t row = first(centre.y); row < last(centre.y); ++row) {
            for (std::size_t column = first(centre.x); column < last(centre.x); ++column) {
                const Point low{static_cast<double>(column) * cell,
                                static_cast<double>(row) * cell};
                const bool inside = std::hypot(low.x - centre.x, low.y - centre.y) <= radius;
                if (!inside || occupied[row * cells + column] || boxes.size() == count) continue;
                occupied[row * cells + column] = true;
                boxes.push_back({low, {low.x + cell, low.y + cell}});
            }
        }
    }
    return boxes;
}

core::batch::ChainLimits chain_limits(std::size_t points) {
    core::batch::ChainLimits limits;
    limits.link = 0.05;
    const double radius = 0.007 * static_cast<double>(points - 1);
    limits.min_area = std::numbers::pi * radius * radius;
    limits.min_closing_side = 0.004;
    limits.min_turn.assign(points - 2, 0.0);
    return limits;
}

std::vector<double> random_headings(std::size_t points, Random& random) {
    std::vector<double> row{random.uniform(0, 1), random.uniform(0, 1),
                            random.uniform(-std::numbers::pi, std::numbers::pi)};
    std::vector<double> turns(points - 2);
    double sum = random.uniform(0, 1);
    for (double& turn : turns) sum += turn = -std::log(1 - random.uniform(0, 1));
    const double total = random.uniform(0, 2 * std::numbers::pi);
    for (const double turn : turns) row.push_back(row.back() + turn * total / sum);
    return row;
}

std::vector<std::vector<double>> valid_chains(std::size_t points, std::size_t count,
                                              const std::vector<Box>& boxes, Random& random) {
    const core::batch::ChainLimits limits = chain_limits(points);
    const geometry::BoxIndex index(boxes);
    std::vector<std::vector<double>> chains;
    std::vector<Point> at(points);
    for (std::size_t tries = 0; tries < 2000 * count && chains.size() < count; ++tries) {
        const std::vector<double> row = random_headings(points, random);
        core::reference::positions(row, limits.link, at);
        bool valid = core::reference::shape_valid(row, at, limits);
        for (std::size_t k = 0; valid && k + 1 < points; ++k) {
            valid = !index.meets({at[k], at[k + 1]});
        }
        if (valid) chains.push_back(row);
    }
    return chains;
}

}  // namespace asv::test
