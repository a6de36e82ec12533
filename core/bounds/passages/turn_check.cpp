#include "core/bounds/passages/turn_check.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <limits>
#include <numbers>

#include "core/bounds/corridors/low_corridors.hpp"
#include "core/bounds/walls.hpp"
#include "geometry/elementary/functions.hpp"

namespace asv::core {

namespace {

/// Parts of the full circle of headings. 11 degrees each: steps of 2 degrees are added on both
/// sides, so that much finer ones would gain little.
constexpr std::size_t parts = 32;
constexpr double part_width = 2 * std::numbers::pi / static_cast<double>(parts);
/// No place is longer, in brooms.
constexpr double longest_place = 2;
/// With more of them every way takes too long to find.
constexpr std::size_t most_places = 4096;
/// Cells of chains after which a node counts as open.
constexpr std::size_t most_cells_of_node = 20'000;

/// The broom whose heading counts: it begins at the middle of the chain, or has it in its middle.
std::size_t broom_of(const Problem& problem) {
    return (problem.asv_count() - 1) / 2;
}

/// Half of what the heading of a broom can change in a step: each end moves by a step at most.
double half_of_turn(const Requirements& requirements) {
    const double shortest = requirements.broom_length - 2 * requirements.tolerance;
    return elementary::asin((requirements.max_step + requirements.tolerance) / shortest);
}

}  // namespace

TurnCheck::TurnCheck(const Problem& problem, std::span<const Box> closed)
    : problem_(problem),
      walls_(walls_of(problem, closed)),
      grid_(widened_bounds(problem.requirements), walls_,
            longest_place * problem.requirements.broom_length) {
    finished_ = grid_.size() > most_places;
    if (finished_) return;
    verdicts_.resize(grid_.size() * parts, Verdict::unknown);
    for (std::size_t place = 0; place < grid_.size(); ++place) {
        const Point middle = geometry::centre(grid_.box(place));
        const auto holds = [&](const Box& wall) { return geometry::contains(wall, middle); };
        if (std::none_of(walls_.begin(), walls_.end(), holds)) continue;
        for (std::size_t part = 0; part < parts; ++part)
            verdicts_[place * parts + part] = Verdict::closed;
    }
    start_ = node_of(problem_.start);
    goal_ = node_of(problem_.goal);
}

std::vector<Box> TurnCheck::walls_of(const Problem& problem, std::span<const Box> closed) {
    std::vector<Box> walls(closed.begin(), closed.end());
    const Requirements& requirements = problem.requirements;
    for (const Box& obstacle : problem.obstacles) {
        const Box wall = shrunk(obstacle, shrink_for_steps(requirements), requirements);
        if (!vanishes(wall)) walls.push_back(wall);
    }
    return walls;
}

std::size_t TurnCheck::node_of(const std::vector<Point>& state) const {
    const std::size_t broom = broom_of(problem_);
    const Point &from = state[broom], &to = state[broom + 1];
    double heading = elementary::atan2(to.y - from.y, to.x - from.x);
    if (heading < 0) heading += 2 * std::numbers::pi;
    const auto part = static_cast<std::size_t>(heading / part_width);
    return grid_.place_at(middle_of_chain(state)) * parts + std::min(part, parts - 1);
}

std::vector<std::size_t> TurnCheck::neighbours(std::size_t node) const {
    const std::size_t place = node / parts, part = node % parts;
    std::vector<std::size_t> beside{place * parts + (part + 1) % parts,
                                    place * parts + (part + parts - 1) % parts};
    for (const std::size_t other : grid_.neighbours(place)) beside.push_back(other * parts + part);
    return beside;
}

/// From start to goal, with as few unknown nodes as possible; empty where there is none.
std::vector<std::size_t> TurnCheck::way() const {
    constexpr auto far = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> unknown_before(verdicts_.size(), far), from(verdicts_.size(), far);
    // Known nodes cost nothing: they go to the front.
    std::deque<std::size_t> queue{start_};
    unknown_before[start_] = 0;
    while (!queue.empty()) {
        const std::size_t node = queue.front();
        queue.pop_front();
        if (node == goal_) break;
        for (const std::size_t next : neighbours(node)) {
            if (verdicts_[next] == Verdict::closed) continue;
            const bool unknown = verdicts_[next] == Verdict::unknown;
            const std::size_t cost = unknown_before[node] + (unknown ? 1 : 0);
            if (cost >= unknown_before[next]) continue;
            unknown_before[next] = cost;
            from[next] = node;
            if (unknown)
                queue.push_back(next);
            else
                queue.push_front(next);
        }
    }
    std::vector<std::size_t> nodes;
    if (unknown_before[goal_] == far) return nodes;
    for (std::size_t node = goal_; node != far; node = from[node]) nodes.push_back(node);
    return nodes;
}

void TurnCheck::work(std::size_t& cells) {
    while (cells > 0 && !finished_) {
        if (waiting_.empty()) {
            const std::vector<std::size_t> nodes = way();
            proven_ = nodes.empty();
            const auto unknown = [&](std::size_t i) { return verdicts_[i] == Verdict::unknown; };
            std::copy_if(nodes.begin(), nodes.end(), std::back_inserter(waiting_), unknown);
            finished_ = waiting_.empty();
            // To find it takes as long as to look at some cells.
            cells -= std::min(cells, verdicts_.size() / parts);
        } else {
            examine_next(cells);
        }
    }
}

EmptyRegion TurnCheck::region_of(std::size_t node) const {
    const Requirements& requirements = problem_.requirements;
    const double low = static_cast<double>(node % parts) * part_width;
    const double more = half_of_turn(requirements);
    return {problem_, grown(grid_.box(node / parts), shrink_for_steps(requirements)),
            BroomHeading{broom_of(problem_), {low - more, low + part_width + more}},
            most_cells_of_node};
}

void TurnCheck::examine_next(std::size_t& cells) {
    const std::size_t node = waiting_.back();
    if (!region_) region_.emplace(region_of(node));
    const EmptyRegion::Answer answer = region_->examine(cells);
    if (answer == EmptyRegion::Answer::unknown) return;
    verdicts_[node] = answer == EmptyRegion::Answer::empty ? Verdict::closed : Verdict::open;
    waiting_.pop_back();
    region_.reset();
}

std::vector<bool> TurnCheck::places_reached_from(std::size_t node) const {
    std::vector<bool> reached(verdicts_.size()), places(grid_.size());
    std::vector<std::size_t> waiting{node};
    reached[node] = true;
    while (!waiting.empty()) {
        const std::size_t here = waiting.back();
        waiting.pop_back();
        places[here / parts] = true;
        for (const std::size_t next : neighbours(here)) {
            if (reached[next] || verdicts_[next] == Verdict::closed) continue;
            reached[next] = true;
            waiting.push_back(next);
        }
    }
    return places;
}

std::vector<Box> TurnCheck::places_to_turn() const {
    const std::vector<bool> from_start = places_reached_from(start_);
    const std::vector<bool> from_goal = places_reached_from(goal_);
    std::vector<Box> places;
    for (std::size_t place = 0; place < grid_.size(); ++place)
        if (from_start[place] && from_goal[place]) places.push_back(grid_.box(place));
    return places;
}

}  // namespace asv::core
