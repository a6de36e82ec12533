#include <algorithm>
#include <array>
#include <cmath>

#include "core/generate/carve.hpp"
#include "core/generate/families.hpp"
#include "core/generate/option_check.hpp"
#include "core/shapes/flat_chain.hpp"
#include "geometry/predicates/distance.hpp"

namespace asv::core {

using geometry::grown;

namespace {

/// The arm of a crossing from the border to the axis of the other road, or as far as a chain needs.
Box arm_region(Branch arm, const Box& flat_road, const Box& upright_road, double needed) {
    const Point middle{(upright_road.low.x + upright_road.high.x) / 2,
                       (flat_road.low.y + flat_road.high.y) / 2};
    switch (arm) {
        case Branch::east:
            return {{std::min(middle.x, 1 - needed), flat_road.low.y}, flat_road.high};
        case Branch::north:
            return {{upright_road.low.x, std::min(middle.y, 1 - needed)}, upright_road.high};
        case Branch::west:
            return {flat_road.low, {std::max(middle.x, needed), flat_road.high.y}};
        default:
            return {upright_road.low, {upright_road.high.x, std::max(middle.y, needed)}};
    }
}

/// A free lane: the stretch of plane within half its width of a polyline.
struct Lane {
    std::vector<Point> corners;
    double half_width = 0;

    bool meets(const Box& box) const {
        for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
            if (geometry::distance({corners[i], corners[i + 1]}, box) <= half_width) return true;
        }
        return false;
    }
};

/// Winds from left to right; as many corners as let it swing freely.
Lane draw_lane(double width, Rng& rng) {
    const double margin = std::min(0.5, width / 2 + 0.01);
    const auto legs = static_cast<std::size_t>(std::clamp(0.5 / width, 1.0, 6.0));
    Lane lane{{}, width / 2};
    for (std::size_t i = 0; i <= legs; ++i) {
        const double share = static_cast<double>(i) / static_cast<double>(legs);
        lane.corners.push_back(
            {margin + share * (1 - 2 * margin), rng.uniform(margin, 1 - margin)});
    }
    return lane;
}

Box disc_region(const Point& centre, double radius) {
    return grown({centre, centre}, radius);
}

}  // namespace

Problem crossing(const CrossingOptions& options, Rng& rng) {
    check(options.chain);
    Problem problem;
    double width = options.road.value(options.chain.asv_count, problem.requirements);
    if (!options.road.absolute) width = std::max(0.25, width);
    require_range("offset", options.offset, 0.0, 0.2);
    const auto axis = [&] {
        const double room = std::max(0.0, 0.5 - width / 2 - 0.02);
        const double offset = std::min(options.offset, room);
        return rng.uniform(0.5 - offset, 0.5 + offset);
    };
    const Point middle{axis(), axis()};
    const Box flat{{0, middle.y - width / 2}, {1, middle.y + width / 2}};
    const Box upright{{middle.x - width / 2, 0}, {middle.x + width / 2, 1}};
    problem.obstacles = carve(unit_square, std::array{flat, upright});

    constexpr std::array arms{Branch::east, Branch::north, Branch::west, Branch::south};
    const Branch start =
        options.start_arm == Branch::random ? arms[rng.below(4)] : options.start_arm;
    Branch goal = options.goal_arm;
    while (goal == Branch::random || (options.goal_arm == Branch::random && goal == start))
        goal = arms[rng.below(4)];
    const double needed = std::min(
        1.0, 1.15 * round_diameter(measured_asvs(options.chain.asv_count), problem.requirements));
    draw_ends(problem, options.chain,
              {arm_region(start, flat, upright, needed), arm_region(goal, flat, upright, needed)},
              rng);
    return problem;
}

Problem clutter(const ClutterOptions& options, Rng& rng) {
    check(options.chain);
    Problem problem;
    require_range("obstacles", options.obstacles, 0u, 1'000'000u);
    require_range("density", options.density, 0.0001, 0.9);
    require_range("side-ratio", options.side_ratio, 1.0, 20.0);
    const double diameter =
        round_diameter(measured_asvs(options.chain.asv_count), problem.requirements);
    const auto count = static_cast<double>(std::max<std::size_t>(options.obstacles, 1));
    const double spacing = 1 / std::sqrt(count);
    // With sides uniform in [s, ratio * s] the mean area is the square of their mean.
    const double mean_side = std::min(0.5, std::sqrt(options.density / count));
    const double least = 2 * mean_side / (1 + options.side_ratio);
    const double gap = spacing - mean_side;
    const double factor =
        options.lane.value_or(gap < diameter && options.obstacles > 0 ? 1.3 : 0.0);
    require_range("lane", factor, 0.0, 5.0);

    const bool has_lane = factor > 0;
    const Lane lane = has_lane ? draw_lane(factor * diameter, rng) : Lane{};
    for (std::size_t placed = 0, tries = 0; placed < options.obstacles; ++tries) {
        if (tries > 100 * (options.obstacles + 100))
            throw NoRoom("the lane leaves no room for boxes");
        const Point size{rng.uniform(least, options.side_ratio * least),
                         rng.uniform(least, options.side_ratio * least)};
        const Point low{rng.uniform(0, 1 - size.x), rng.uniform(0, 1 - size.y)};
        const Box box{low, {low.x + size.x, low.y + size.y}};
        if (has_lane && lane.meets(box)) continue;
        problem.obstacles.push_back(box);
        ++placed;
    }
    const double width = std::clamp(1.15 * diameter, 0.45, 1.0);
    const EndRegions regions = has_lane
                                   ? EndRegions{disc_region(lane.corners.front(), lane.half_width),
                                                disc_region(lane.corners.back(), lane.half_width)}
                                   : EndRegions{{{0, 0}, {width, 1}}, {{1 - width, 0}, {1, 1}}};
    draw_ends(problem, options.chain, regions, rng);
    return problem;
}

}  // namespace asv::core
