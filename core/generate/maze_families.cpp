#include <algorithm>
#include <string>
#include <utility>

#include "core/generate/carve.hpp"
#include "core/generate/families.hpp"
#include "core/generate/option_check.hpp"
#include "core/shapes/flat_chain.hpp"

namespace asv::core {

namespace {

Box hull(const Box& a, const Box& b) {
    return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
            {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
}

/// A spanning tree of a square grid of cells, grown by depth-first search from cell 0 (lower left).
struct CellTree {
    std::vector<std::size_t> parent;  ///< row by row; cell 0 is its own parent
    std::vector<std::size_t> depth;
};

CellTree draw_tree(std::size_t side, Rng& rng) {
    const std::size_t none = side * side;
    CellTree tree{std::vector(none, none), std::vector<std::size_t>(none, 0)};
    std::vector<std::size_t> stack{0};
    tree.parent[0] = 0;
    while (!stack.empty()) {
        const std::size_t cell = stack.back();
        std::vector<std::size_t> next;
        const auto offer = [&](bool exists, std::size_t neighbour) {
            if (exists && tree.parent[neighbour] == none) next.push_back(neighbour);
        };
        offer(cell % side + 1 < side, cell + 1);
        offer(cell % side > 0, cell - 1);
        offer(cell / side + 1 < side, cell + side);
        offer(cell / side > 0, cell - side);
        if (next.empty()) {
            stack.pop_back();
            continue;
        }
        const std::size_t chosen = next[rng.below(next.size())];
        tree.parent[chosen] = cell;
        tree.depth[chosen] = tree.depth[cell] + 1;
        stack.push_back(chosen);
    }
    return tree;
}

/// The corners of a square spiral from the lower left corner inwards, for the axes of a way of the
/// given width with walls of the given thickness between its turns.
std::vector<Point> spiral_corners(double way, double wall, std::size_t max_legs) {
    const double pitch = way + wall;
    std::vector<Point> corners{{way / 2, way / 2}};
    Box free{{way / 2, way / 2}, {1 - way / 2, 1 - way / 2}};  // where the axis may still go
    for (std::size_t leg = 0; leg < max_legs; ++leg) {
        Point next = corners.back();
        // The leg that is done takes one pitch off the side that it ran along.
        switch (leg % 4) {
            case 0:
                next.x = free.high.x;
                free.low.y += pitch;
                break;
            case 1:
                next.y = free.high.y;
                free.high.x -= pitch;
                break;
            case 2:
                next.x = free.low.x;
                free.high.y -= pitch;
                break;
            default:
                next.y = free.low.y;
                free.low.x += pitch;
                break;
        }
        const Point last = corners.back();
        const double ahead = leg % 4 == 0   ? next.x - last.x
                             : leg % 4 == 1 ? next.y - last.y
                             : leg % 4 == 2 ? last.x - next.x
                                            : last.y - next.y;
        if (ahead < pitch) break;
        corners.push_back(next);
    }
    return corners;
}

Box leg_box(const Point& a, const Point& b, double way) {
    return grown(hull({a, a}, {b, b}), way / 2);
}

/// The first part of a leg: as long as three ways are wide, or all of it.
Box leg_beginning(const Point& from, const Point& to, double way) {
    const double length = std::abs(to.x - from.x) + std::abs(to.y - from.y);
    const double share = std::min(1.0, 2 * way / length);
    return leg_box(from, {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y)}, way);
}

}  // namespace

double WayWidth::value(std::size_t asv_count, const Requirements& requirements) const {
    if (absolute) {
        require_range("way", *absolute, 0.005, 0.9);
        return *absolute;
    }
    require_range("way-factor", factor, 0.1, 20.0);
    const double width = factor * round_diameter(measured_asvs(asv_count), requirements);
    require_derived(asv_count, "a way", "wide", width, 0.005, 0.9);
    return width;
}

Problem maze(const MazeOptions& options, Rng& rng) {
    check(options.chain);
    Problem problem;
    const double way = options.way.value(options.chain.asv_count, problem.requirements);
    require_range("wall", options.wall, 0.001, 0.3);
    const auto fitting = static_cast<std::size_t>((1 - way) / (way + options.wall) + 1e-9) + 1;
    const std::size_t side = options.cells.value_or(std::min<std::size_t>(fitting, 60));
    if (side < 2 || side > fitting)
        throw std::invalid_argument("cells: " + std::to_string(fitting) + " of way " +
                                    std::to_string(way) + " fit on a side; 2 or more are needed");
    const double pitch = (1 - way) / static_cast<double>(side - 1);
    const auto cell = [&](std::size_t index) {
        const Point low{pitch * static_cast<double>(index % side),
                        pitch * static_cast<double>(index / side)};
        return Box{low, {low.x + way, low.y + way}};
    };
    const CellTree tree = draw_tree(side, rng);
    std::vector<Box> passages;
    for (std::size_t i = 0; i < tree.parent.size(); ++i)
        passages.push_back(hull(cell(i), cell(tree.parent[i])));
    problem.obstacles = carve(unit_square, passages);

    const auto last = static_cast<std::size_t>(
        std::max_element(tree.depth.begin(), tree.depth.end()) - tree.depth.begin());
    std::size_t second = last;
    while (tree.parent[second] != 0) second = tree.parent[second];
    draw_ends(problem, options.chain,
              {hull(cell(0), cell(second)), hull(cell(last), cell(tree.parent[last]))}, rng);
    return problem;
}

Problem spiral(const SpiralOptions& options, Rng& rng) {
    check(options.chain);
    Problem problem;
    const double way = options.way.value(options.chain.asv_count, problem.requirements);
    require_range("wall", options.wall, 0.001, 0.3);
    if (options.legs) require_range("legs", *options.legs, 2u, 200u);
    const auto corners = spiral_corners(way, options.wall, options.legs.value_or(200));
    const std::size_t legs = corners.size() - 1;
    if (legs < 2 || (options.legs && legs < *options.legs))
        throw std::invalid_argument("legs: only " + std::to_string(legs) + " legs of way " +
                                    std::to_string(way) + " fit");
    std::vector<Box> passages;
    for (std::size_t i = 0; i < legs; ++i)
        passages.push_back(leg_box(corners[i], corners[i + 1], way));
    problem.obstacles = carve(unit_square, passages);

    EndRegions regions{leg_beginning(corners[0], corners[1], way),
                       leg_beginning(corners[legs], corners[legs - 1], way)};
    const bool outward = options.direction == SpiralDirection::outward ||
                         (options.direction == SpiralDirection::random && rng.chance(0.5));
    if (outward) std::swap(regions.start, regions.goal);
    draw_ends(problem, options.chain, regions, rng);
    return problem;
}

}  // namespace asv::core
