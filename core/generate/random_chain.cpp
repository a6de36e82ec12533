#include "core/generate/random_chain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "core/generate/option_check.hpp"
#include "core/model/planning_window.hpp"
#include "geometry/elementary/functions.hpp"
#include "geometry/predicates/distance.hpp"
#include "geometry/predicates/polygon.hpp"

namespace asv::core {

namespace {

constexpr double full_turn = 2 * std::numbers::pi;
// A shape is cheap and most are refused in narrow rooms; places of one shape are more alike.
constexpr int shapes_tried = 30'000;
constexpr int places_tried = 30;
// A goal whose fence would cross the start is drawn again.
constexpr int fences_tried = 1000;
// Between the goal and its fence, and the thickness of that: ten primitive steps, so that nothing
// jumps over it. Lengths in workspace units, for brooms 0.05 long.
constexpr double fence_gap = 0.002;
constexpr double fence_thickness = 0.01;

double turn(const Point& a, const Point& b, const Point& c) {
    const Point u{b.x - a.x, b.y - a.y};
    const Point v{c.x - b.x, c.y - b.y};
    return elementary::atan2(u.x * v.y - u.y * v.x, u.x * v.x + u.y * v.y);
}

bool acceptable(std::span<const Point> chain, const ChainOptions& options,
                const Requirements& requirements) {
    const std::size_t n = chain.size();
    const double closing =
        elementary::hypot(chain.front().x - chain.back().x, chain.front().y - chain.back().y);
    // The margin of 0.2 keeps the two turns at the closing side away from pi as well: there a
    // rounding error would decide.
    const double most = std::numbers::pi - 0.2;
    const double last = turn(chain[n - 2], chain[n - 1], chain[0]);
    const double first = turn(chain[n - 1], chain[0], chain[1]);
    return closing >= options.min_closing_side && last >= options.min_turn && last <= most &&
           first >= options.min_turn && first <= most &&
           geometry::signed_area(chain) >= (1 + options.area_margin) * requirements.min_area(n);
}

std::vector<double> draw_turns(std::size_t count, double min_turn, Rng& rng) {
    constexpr std::array concentrations{0.15, 0.4, 1.0, 3.0, 10.0, 100.0};
    const double concentration = concentrations[rng.below(concentrations.size())];
    const double total = rng.uniform(0, full_turn);
    std::vector<double> turns(count);
    double sum = 0;
    for (double& value : turns) sum += value = rng.gamma(concentration);
    if (!(sum > 0)) return turns;
    const double shared = std::max(0.0, total - min_turn * static_cast<double>(count));
    for (double& value : turns) value = min_turn + shared * value / sum;
    return turns;
}

bool is_free(std::span<const Point> chain, std::span<const Box> obstacles, double clearance) {
    // A lone ASV is drawn free as well, though it would meet nothing: that looks like a problem.
    for (std::size_t i = 0; i == 0 || i + 1 < chain.size(); ++i) {
        const geometry::Segment broom{chain[i], chain[std::min(i + 1, chain.size() - 1)]};
        const Box near = grown(bounding_box(std::array{broom.a, broom.b}), clearance);
        for (const Box& obstacle : obstacles) {
            if (obstacle.low.x > near.high.x || obstacle.high.x < near.low.x ||
                obstacle.low.y > near.high.y || obstacle.high.y < near.low.y)
                continue;
            if (geometry::distance(broom, obstacle) <= clearance) return false;
        }
    }
    return true;
}

/// The chain moved to a random place inside the region; nothing when it is too large for it.
std::optional<std::vector<Point>> drawn_place(std::vector<Point> chain, const Box& region,
                                              Rng& rng) {
    const Box box = bounding_box(chain);
    const Point least{region.low.x - box.low.x, region.low.y - box.low.y};
    const Point most{region.high.x - box.high.x, region.high.y - box.high.y};
    if (least.x > most.x || least.y > most.y) return std::nullopt;
    const Point shift{rng.uniform(least.x, most.x), rng.uniform(least.y, most.y)};
    for (Point& point : chain) point = {point.x + shift.x, point.y + shift.y};
    return chain;
}

std::vector<Point> draw_end(const Problem& problem, const ChainOptions& options, const Box& region,
                            Orientation orientation, Rng& rng) {
    const double length = problem.requirements.broom_length;
    const double room =
        std::max(0.0, region.high.x - region.low.x) * std::max(0.0, region.high.y - region.low.y);
    if (problem.requirements.min_area(options.asv_count) > room)
        throw NoRoom(std::to_string(options.asv_count) +
                     " ASVs have to enclose more than there is where they have to stand; leave "
                     "more room");
    for (int i = 0; i < shapes_tried; ++i) {
        if (options.asv_count == 1) {
            const auto place = drawn_place({Point{0, 0}}, region, rng);
            if (place && is_free(*place, problem.obstacles, options.clearance)) return *place;
            continue;
        }
        std::vector<double> turns = random_turns(options, problem.requirements, rng);
        if (orientation == Orientation::clockwise)
            for (double& value : turns) value = -value;
        for (int k = 0; k < places_tried; ++k) {
            const auto place = drawn_place(
                chain_positions(turns, rng.uniform(0, full_turn), {0, 0}, length), region, rng);
            if (place && is_free(*place, problem.obstacles, options.clearance)) return *place;
        }
    }
    throw NoRoom("no start or goal of " + std::to_string(options.asv_count) +
                 " ASVs was found where it has to stand; leave more room");
}

Orientation opposite(Orientation orientation) {
    return orientation == Orientation::clockwise ? Orientation::counter_clockwise
                                                 : Orientation::clockwise;
}

/// Of the brooms, as a multiple of those of the public assignment.
double size_of_brooms(const Problem& problem) {
    return problem.requirements.broom_length / Requirements{}.broom_length;
}

/// Four boxes around the chain, each as long as to overlap its neighbours at the corners.
std::array<Box, 4> fence_around(std::span<const Point> chain, double size) {
    const Box inside = grown(bounding_box(chain), size * fence_gap);
    const Box outside = grown(inside, size * fence_thickness);
    return {{{outside.low, {outside.high.x, inside.low.y}},
             {{outside.low.x, inside.high.y}, outside.high},
             {outside.low, {inside.low.x, outside.high.y}},
             {{inside.high.x, outside.low.y}, outside.high}}};
}

/// Adds a fence around the goal. False, and nothing is added, where it would meet the start or have
/// the start inside.
bool fence_goal(Problem& problem, double clearance) {
    const std::array<Box, 4> fence = fence_around(problem.goal, size_of_brooms(problem));
    const Box around{fence[0].low, fence[1].high};
    const Point& first = problem.start.front();
    const bool enclosed = first.x >= around.low.x && first.x <= around.high.x &&
                          first.y >= around.low.y && first.y <= around.high.y;
    if (enclosed || !is_free(problem.start, fence, clearance)) return false;
    problem.obstacles.insert(problem.obstacles.end(), fence.begin(), fence.end());
    return true;
}

Box inner_region(const Box& region, const Box& bounds, double clearance) {
    const Box inside = grown(bounds, -clearance);
    return {{std::max(region.low.x, inside.low.x), std::max(region.low.y, inside.low.y)},
            {std::min(region.high.x, inside.high.x), std::min(region.high.y, inside.high.y)}};
}

/// Draws the goal, and a fence around it where the options ask for one.
void draw_goal_in(Problem& problem, const ChainOptions& options, const Box& region,
                  Orientation orientation_of_start, Rng& rng) {
    const bool turned = options.obstruction == Obstruction::turned;
    const Orientation orientation = turned ? opposite(orientation_of_start) : orientation_of_start;
    for (int i = 0; i < fences_tried; ++i) {
        problem.goal = draw_end(problem, options, region, orientation, rng);
        if (options.obstruction != Obstruction::fenced || fence_goal(problem, options.clearance))
            return;
    }
    throw NoRoom("no goal of " + std::to_string(options.asv_count) +
                 " ASVs was found whose fence keeps off the start; leave more room");
}

}  // namespace

void check(const ChainOptions& options) {
    require_range("asvs", options.asv_count, 1, 200);
    if (options.asv_count == 2)
        throw std::invalid_argument("asvs must be 1 or 3 to 200: two enclose no area");
    if (options.asv_count == 1 && options.obstruction != Obstruction::none)
        throw std::invalid_argument("infeasible: there is always a path for one ASV");
    require_range("clearance", options.clearance, 0, 0.1);
    require_range("area-margin", options.area_margin, 0, 0.2);
    require_range("least-turn", options.min_turn, 0, 0.01);
    require_range("least-closing", options.min_closing_side, 0, 0.05);
}

std::size_t measured_asvs(std::size_t asv_count) {
    constexpr std::size_t fewest = 3;
    return std::max(fewest, asv_count);
}

std::vector<double> random_turns(const ChainOptions& options, const Requirements& requirements,
                                 Rng& rng) {
    // A shape is accepted once in 3 to 200 draws; the cap only guards against requirements that no
    // shape meets.
    for (int i = 0; i < 1'000'000; ++i) {
        std::vector<double> turns = draw_turns(options.asv_count - 2, options.min_turn, rng);
        const auto chain = chain_positions(turns, 0, {0, 0}, requirements.broom_length);
        if (acceptable(chain, options, requirements)) return turns;
    }
    throw NoRoom("no shape of " + std::to_string(options.asv_count) +
                 " ASVs meets the requirements with these margins");
}

void draw_ends(Problem& problem, const ChainOptions& options, const EndRegions& regions, Rng& rng) {
    Orientation orientation = options.orientation;
    if (orientation == Orientation::random)
        orientation = rng.chance(0.5) ? Orientation::clockwise : Orientation::counter_clockwise;
    const Box bounds = problem.requirements.bounds;
    problem.start = draw_end(
        problem, options, inner_region(regions.start, bounds, options.clearance), orientation, rng);
    draw_goal_in(problem, options, inner_region(regions.goal, bounds, options.clearance),
                 orientation, rng);
}

void draw_goal(Problem& problem, const ChainOptions& options, Rng& rng) {
    if (problem.body_kind() != BodyKind::chain)
        throw std::invalid_argument("a goal is drawn for a chain of ASVs alone");
    ChainOptions scaled = options;
    scaled.asv_count = problem.asv_count();
    check(scaled);
    scaled.clearance *= size_of_brooms(problem);
    scaled.min_closing_side *= size_of_brooms(problem);
    // Around what there is; a goal there is not yet.
    problem.goal = problem.start;
    const Box window = planning_window(problem);
    draw_goal_in(problem, scaled, inner_region(window, window, scaled.clearance),
                 geometry::signed_area(problem.start) < 0 ? Orientation::clockwise
                                                          : Orientation::counter_clockwise,
                 rng);
}

}  // namespace asv::core
