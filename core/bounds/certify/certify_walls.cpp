#include "core/bounds/certify/certify_walls.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "core/bounds/asv_plane.hpp"
#include "core/bounds/certify/needed.hpp"
#include "core/bounds/corridors/area_between_walls.hpp"
#include "core/bounds/corridors/low_corridors.hpp"
#include "core/bounds/seams.hpp"
#include "core/bounds/walls.hpp"

namespace asv::core {

namespace {

using Obstacles = std::vector<std::size_t>;

/// Obstacles, seams or corridors to look at before no more are dropped: about a second.
constexpr std::size_t most_effort = 1'000'000;

/// Of more the checker of certificates would refuse.
constexpr std::size_t most_obstacles = 2000;

Obstacles all_of(const Problem& problem) {
    Obstacles all(problem.obstacles.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

Problem with_obstacles(const Problem& problem, const Obstacles& obstacles) {
    Problem some = problem;
    some.obstacles.clear();
    for (const std::size_t i : obstacles) some.obstacles.push_back(problem.obstacles[i]);
    return some;
}

bool separates(geometry::FreePlane plane, const Point& start, const Point& goal) {
    return plane.is_free(start) && plane.is_free(goal) && !plane.connected(start, goal);
}

/// Do these obstacles, shrunk, and these boxes?
bool separate(const Problem& problem, const Obstacles& obstacles, const std::vector<Box>& boxes,
              const Point& start, const Point& goal) {
    const double shrink = shrink_for_steps(problem.requirements);
    ShrunkObstacles walls = shrink_obstacles(with_obstacles(problem, obstacles), shrink);
    walls.boxes.insert(walls.boxes.end(), boxes.begin(), boxes.end());
    return separates({walls.boxes, walls.bounds}, start, goal);
}

/// How far a wall's side is moved.
double shrink_of(const std::optional<std::size_t>& wall, const Requirements& requirements) {
    return wall ? shrink_for_steps(requirements) : requirements.tolerance;
}

/// Where two walls are abreast of each other, and from where to where it is between them.
struct Between {
    double from, to, low, high;
};

Between between_walls(const FacingWalls& facing, const Problem& problem) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const auto turned = [&](const Box& box) {
        return facing.upright ? box : geometry::transposed(box);
    };
    const Box bounds = turned(problem.requirements.bounds);
    Between between{-infinity, infinity, bounds.low.x, bounds.high.x};
    const auto& [first, second] = facing.walls;
    for (const auto& wall : facing.walls) {
        if (!wall) continue;
        const Box box = turned(problem.obstacles[*wall]);
        between.from = std::max(between.from, box.low.y);
        between.to = std::min(between.to, box.high.y);
    }
    if (first) between.low = turned(problem.obstacles[*first]).high.x;
    if (second) between.high = turned(problem.obstacles[*second]).low.x;
    return between;
}

ClosedSeam described(const FacingWalls& facing, const Problem& problem) {
    const Requirements& r = problem.requirements;
    const Between place = between_walls(facing, problem);
    const double shrink = shrink_for_steps(r);
    const Box gap{{place.low - shrink_of(facing.walls[0], r), place.from + shrink},
                  {place.high + shrink_of(facing.walls[1], r), place.to - shrink}};
    return {facing, facing.upright ? gap : geometry::transposed(gap),
            place.high - place.low + 2 * r.tolerance, gap.high.y - gap.low.y};
}

/// The seams between these obstacles that no chain gets through.
std::vector<ClosedSeam> closed_seams(const Problem& problem, const Obstacles& obstacles) {
    const Requirements& r = problem.requirements;
    struct NumberedWall {
        Wall wall;
        std::optional<std::size_t> obstacle;
    };
    std::vector<NumberedWall> walls;
    for (const Wall& wall : outside(r)) walls.push_back({wall, std::nullopt});
    for (const std::size_t i : obstacles) {
        const Box smaller = shrunk(problem.obstacles[i], shrink_for_steps(r), r);
        if (!vanishes(smaller)) walls.push_back({{problem.obstacles[i], smaller}, i});
    }
    std::vector<ClosedSeam> closed;
    for (const bool upright : {true, false}) {
        for (const auto& [left, first] : walls) {
            for (const auto& [right, second] : walls) {
                if (!first && !second) continue;
                if (right.shrunk.low.x < left.shrunk.high.x) continue;
                const auto seam = vertical_seam(left, right, r.tolerance);
                if (seam && is_impassable(*seam, problem))
                    closed.push_back(described({{first, second}, upright}, problem));
            }
        }
        for (auto& [wall, obstacle] : walls)
            wall = {transposed(wall.whole), transposed(wall.shrunk)};
    }
    return closed;
}

template <typename Closed>
std::vector<Box> boxes_of(const std::vector<Closed>& closed, Box Closed::*box) {
    std::vector<Box> boxes;
    for (const Closed& one : closed) boxes.push_back(one.*box);
    return boxes;
}

ClosedCorridor described(const LowCorridor& corridor, const Problem& problem) {
    const Requirements& r = problem.requirements;
    const FacingWalls facing{corridor.walls, corridor.upright};
    const Between place = between_walls(facing, problem);
    const double broom = r.broom_length + r.tolerance;
    const double chain = broom * static_cast<double>(problem.asv_count() - 1);
    const double mouth = r.tolerance + chain / 2 + (r.max_step + r.tolerance) / 2;
    const double height = place.high - place.low + 2 * r.tolerance;
    const double area =
        height > 0 ? max_area_between_walls(problem.asv_count(), broom, height, true) : 0;
    return {facing, place.from + mouth, place.to - mouth, place.high - place.low, area};
}

}  // namespace

std::optional<InfeasibilityProof> certify_separation(const Problem& problem, std::size_t asv) {
    // A seam says something of the middle of the chain.
    const bool seams_needed =
        !separate(problem, all_of(problem), {}, problem.start[asv], problem.goal[asv]);
    if (seams_needed) asv = (problem.asv_count() - 1) / 2;
    const Point& start = problem.start[asv];
    const Point& goal = problem.goal[asv];
    const auto suffices = [&](const Obstacles& obstacles) {
        if (!seams_needed) return separate(problem, obstacles, {}, start, goal);
        return separates(make_asv_plane(with_obstacles(problem, obstacles), Reading::literal),
                         start, goal);
    };
    SeparationProof proof{asv, shrink_for_steps(problem.requirements),
                          needed(all_of(problem), suffices, most_effort)};
    if (proof.obstacles.size() > most_obstacles) return std::nullopt;
    if (!seams_needed) return proof;
    const auto seams_suffice = [&](const std::vector<ClosedSeam>& seams) {
        return separate(problem, proof.obstacles, boxes_of(seams, &ClosedSeam::gap), start, goal);
    };
    proof.seams = needed(closed_seams(problem, proof.obstacles), seams_suffice, most_effort);
    return proof;
}

std::optional<InfeasibilityProof> certify_corridors(const Problem& problem) {
    const Point start = middle_of_chain(problem.start), goal = middle_of_chain(problem.goal);
    const std::vector<LowCorridor> all = find_low_corridors(problem);
    const auto among = [&](const Obstacles& obstacles) {
        std::vector<LowCorridor> some;
        for (const LowCorridor& corridor : all) {
            const auto is_there = [&](const std::optional<std::size_t>& wall) {
                return !wall || std::binary_search(obstacles.begin(), obstacles.end(), *wall);
            };
            if (std::all_of(corridor.walls.begin(), corridor.walls.end(), is_there))
                some.push_back(corridor);
        }
        return some;
    };
    CorridorProof proof;
    const auto suffices = [&](const Obstacles& obstacles) {
        return separate(problem, obstacles, boxes_of(among(obstacles), &LowCorridor::closed), start,
                        goal);
    };
    proof.obstacles = needed(all_of(problem), suffices, most_effort);
    if (proof.obstacles.size() > most_obstacles) return std::nullopt;
    const auto corridors_suffice = [&](const std::vector<LowCorridor>& corridors) {
        return separate(problem, proof.obstacles, boxes_of(corridors, &LowCorridor::closed), start,
                        goal);
    };
    for (const LowCorridor& corridor :
         needed(among(proof.obstacles), corridors_suffice, most_effort))
        proof.corridors.push_back(described(corridor, problem));
    const Requirements& r = problem.requirements;
    proof.shrink = shrink_for_steps(r);
    proof.required_area = r.min_area(problem.asv_count()) - r.tolerance;
    return proof;
}

}  // namespace asv::core
