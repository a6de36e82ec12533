#include "core/bounds/seams.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "geometry/boxes/span.hpp"
#include "geometry/elementary/functions.hpp"

namespace asv::core {

namespace {

/// The left side of a shrunk wall and how high the wall is: what most pairs are refused by, side by
/// side in memory.
struct LeftSide {
    double x;
    double low, high;
    const Wall* wall;
};

std::vector<LeftSide> from_left_to_right(const std::vector<Wall>& walls) {
    std::vector<LeftSide> sides;
    sides.reserve(walls.size());
    for (const Wall& wall : walls)
        sides.push_back({wall.shrunk.low.x, wall.whole.low.y, wall.whole.high.y, &wall});
    std::sort(sides.begin(), sides.end(),
              [](const LeftSide& a, const LeftSide& b) { return a.x < b.x; });
    return sides;
}

/// Adds the seams between walls that lie side by side, not one above the other.
void add_vertical_seams(const std::vector<Wall>& walls, const Requirements& requirements,
                        double max_gap, std::vector<Seam>& seams) {
    const std::vector<LeftSide> sides = from_left_to_right(walls);
    // Twice the tolerance, as vertical_seam decides.
    const double above = 2 * requirements.tolerance;
    for (const Wall& left : walls) {
        const double x = left.shrunk.high.x;
        const double low = left.whole.low.y - above, high = left.whole.high.y + above;
        auto next = std::partition_point(sides.begin(), sides.end(),
                                         [x](const LeftSide& side) { return side.x < x; });
        for (; next != sides.end() && next->x <= x + max_gap; ++next) {
            if (next->low > high || next->high < low) continue;
            const auto seam = vertical_seam(left, *next->wall, requirements.tolerance);
            if (seam) seams.push_back(*seam);
        }
    }
}

}  // namespace

std::optional<Seam> vertical_seam(const Wall& left, const Wall& right, double tolerance) {
    const double gap = right.whole.low.x - left.whole.high.x;
    if (gap > tolerance) return std::nullopt;
    if (apart(y_span(left.whole), y_span(right.whole)) > tolerance) return std::nullopt;
    const Box& a = left.shrunk;
    const Box& b = right.shrunk;
    const geometry::Span y = between(y_span(a), y_span(b));
    Seam seam;
    seam.gap = {{a.high.x, y.low}, {b.low.x, y.high}};
    seam.width = gap + 2 * tolerance;
    seam.depth = std::max(0.0, -apart(y_span(a), y_span(b)));
    return seam;
}

ShrunkObstacles shrink_obstacles(const Problem& problem, double shrink) {
    ShrunkObstacles left;
    left.bounds = widened_bounds(problem.requirements);
    left.boxes.reserve(problem.obstacles.size());
    for (const Box& box : problem.obstacles) {
        const Box smaller = shrunk(box, shrink, problem.requirements);
        if (!vanishes(smaller)) left.boxes.push_back(smaller);
    }
    return left;
}

std::vector<Seam> find_seams(const Problem& problem, double shrink) {
    const Requirements& requirements = problem.requirements;
    const double margin = shrink + rounding_slack(requirements);
    const Box& bounds = requirements.bounds;
    std::vector<Wall> walls = outside(requirements);
    walls.reserve(walls.size() + problem.obstacles.size());
    for (const Box& box : problem.obstacles) {
        const Box smaller = shrunk(box, shrink, requirements);
        if (!vanishes(smaller) && overlap(smaller, bounds)) walls.push_back({box, smaller});
    }
    // Two sides that are the tolerance apart are each shrunk by the margin; twice the tolerance
    // more than that leaves room for rounding, and vertical_seam decides.
    const double max_gap = 2 * margin + 3 * requirements.tolerance;
    std::vector<Seam> seams;
    add_vertical_seams(walls, requirements, max_gap, seams);
    const auto horizontal = static_cast<std::ptrdiff_t>(seams.size());
    for (Wall& wall : walls) wall = {transposed(wall.whole), transposed(wall.shrunk)};
    add_vertical_seams(walls, requirements, max_gap, seams);
    std::for_each(seams.begin() + horizontal, seams.end(),
                  [](Seam& seam) { seam.gap = transposed(seam.gap); });
    return seams;
}

bool is_impassable(const Seam& seam, const Problem& problem) {
    const Requirements& r = problem.requirements;
    const auto n = static_cast<double>(problem.asv_count());
    if (n < 3) return false;
    const double margin = r.broom_length / 20;
    const double broom = r.broom_length + r.tolerance;
    const double inside = seam.depth / 2 - (r.max_step + r.tolerance) / 2 - margin;
    if (inside < 0 || seam.width >= margin) return false;
    const double steep = elementary::asin(std::max(0.0, seam.width) / margin);
    const double on_one_side = std::floor(inside / broom) + 1;
    const double count = std::min(std::floor((n - 1) / 2), on_one_side) +
                         std::min(std::ceil((n - 1) / 2), on_one_side);
    const double chain = (n - 1) * broom;
    const double row = count * broom;
    const double straight = (chain * chain - row * row * (1 - elementary::tan(steep))) / 4;
    const double widened = std::min(2 * steep + n * r.tolerance, std::numbers::pi / 2);
    const double folded = 2 * chain * chain * elementary::sin(widened);
    const double required = r.min_area(problem.asv_count()) - r.tolerance;
    return std::max(folded, straight) < required * (1 - 1e-9);
}

}  // namespace asv::core
