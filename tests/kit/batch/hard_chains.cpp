#include "tests/kit/batch/hard_chains.hpp"

#include <utility>

#include "core/benchmark/scalar_chain.hpp"
#include "tests/kit/batch/batch_worlds.hpp"
#include "tests/kit/geometry/scalar_sin_cos.hpp"

namespace asv::test {

using core::batch::ChainLimits;
using geometry::Box;
using geometry::Point;

std::vector<Point> kernel_positions(const HeadingRow& row, const ChainLimits& limits) {
    std::vector<Point> points{{0, 0}};
    const std::size_t links = row.size() - 2;
    for (std::size_t k = 0; k < links && !limits.anchor_lever.empty(); ++k) {
        const auto [sine, cosine] = scalar_sin_cos(row[2 + k]);
        const double arm = limits.link * limits.anchor_lever[k];
        points[0] = {points[0].x + arm * cosine, points[0].y + arm * sine};
    }
    points[0] = {row[0] + points[0].x, row[1] + points[0].y};
    for (std::size_t k = 0; k < links; ++k) {
        const auto [sine, cosine] = scalar_sin_cos(row[2 + k]);
        points.push_back({points[k].x + limits.link * cosine, points[k].y + limits.link * sine});
    }
    return points;
}

std::vector<HeadingRow> random_chains(std::size_t points, std::size_t count, Random& random,
                                      const ChainLimits& limits) {
    std::vector<HeadingRow> chains;
    std::vector<Point> scratch(points);
    while (chains.size() < count) {
        const HeadingRow row = random_headings(points, random);
        core::reference::positions(row, limits.link, scratch);
        // Every eighth may violate anything, the others collide at most.
        if (chains.size() % 8 == 0 || core::reference::shape_valid(row, scratch, limits)) {
            chains.push_back(row);
        }
    }
    return chains;
}

std::vector<Box> hard_boxes(std::size_t count, std::span<const HeadingRow> chains,
                            const ChainLimits& limits, Adversary& draw) {
    std::vector<Box> boxes;
    while (boxes.size() < count) {
        const std::vector<Point> points = kernel_positions(
            chains[static_cast<std::size_t>(draw.pick(static_cast<int>(chains.size())))], limits);
        const auto k = static_cast<std::size_t>(draw.pick(static_cast<int>(points.size()) - 1));
        const double t = draw.pick(3) == 0 ? 0 : draw.uniform(0, 1);
        const Point on_link{points[k].x + t * (points[k + 1].x - points[k].x),
                            points[k].y + t * (points[k + 1].y - points[k].y)};
        const Point far{draw.uniform(0, 1), draw.uniform(0, 1)};
        const Point corner = draw.pick(3) == 0 ? draw.nudged(on_link) : far;
        const double wide = draw.pick(5) == 0 ? 0 : draw.uniform(0, 0.03);
        const double high = draw.pick(5) == 0 ? 0 : draw.uniform(0, 0.03);
        Box box{corner, {corner.x + wide, corner.y + high}};
        if (draw.pick(2) == 0) box = {{corner.x - wide, corner.y - high}, corner};
        if (draw.pick(30) == 0) std::swap(box.low, box.high);
        boxes.push_back(box);
    }
    return boxes;
}

}  // namespace asv::test
