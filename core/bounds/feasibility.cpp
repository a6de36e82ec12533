#include "core/bounds/feasibility.hpp"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

#include "core/bounds/asv_plane.hpp"
#include "core/bounds/chain_limits.hpp"
#include "core/bounds/corridors/low_corridors.hpp"
#include "core/bounds/passages/passage_check.hpp"
#include "core/model/planning_window.hpp"
#include "geometry/predicates/polygon.hpp"

namespace asv::core {

namespace {

bool lacks_area(const Problem& problem) {
    // A curve of a given length encloses most together with its chord when it is half a circle.
    const double length = longest_chain(problem);
    const double largest = problem.asv_count() < 3 ? 0 : length * length / (2 * std::numbers::pi);
    return largest < least_area(problem);
}

bool has_opposite_orientation(const Problem& problem) {
    const double start = geometry::signed_area(problem.start);
    const double goal = geometry::signed_area(problem.goal);
    const double least = least_area(problem);
    return start * goal < 0 && std::abs(start) >= least && std::abs(goal) >= least &&
           keeps_orientation(problem);
}

/// The first ASV whose start and goal are free but not connected.
std::optional<std::size_t> find_separated(const Problem& problem, Reading reading) {
    geometry::FreePlane space = make_asv_plane(problem, reading);
    for (std::size_t i = 0; i < problem.asv_count(); ++i) {
        const Point& start = problem.start[i];
        const Point& goal = problem.goal[i];
        if (space.is_free(start) && space.is_free(goal) && !space.connected(start, goal)) return i;
    }
    return std::nullopt;
}

constexpr const char* but_for_tolerance =
    ", unless it slips through where only the tolerance leaves a way";

std::vector<Box> closed_parts(const std::vector<LowCorridor>& corridors) {
    std::vector<Box> closed;
    for (const LowCorridor& corridor : corridors) closed.push_back(corridor.closed);
    return closed;
}

/// Do the corridors keep the middle of the chain from its goal?
bool separate(const std::vector<LowCorridor>& corridors, const Problem& problem, Reading reading) {
    const std::vector<Box> closed = closed_parts(corridors);
    const auto plane = [&]() -> geometry::FreePlane {
        if (reading == Reading::intended) return make_asv_plane(problem, reading, closed);
        return make_middle_plane(problem, closed);
    };
    geometry::FreePlane space = plane();
    const Point start = middle_of_chain(problem.start);
    const Point goal = middle_of_chain(problem.goal);
    return space.is_free(start) && space.is_free(goal) && !space.connected(start, goal);
}

/// Those of the corridors without which there would be a way, all of them higher than what the
/// tolerance opens. All where they are too many to try.
std::vector<LowCorridor> decisive(std::vector<LowCorridor> corridors, const Problem& problem,
                                  Reading reading) {
    constexpr std::size_t most_to_try = 100;
    if (corridors.size() <= most_to_try) {
        for (std::size_t i = corridors.size(); i-- > 0;) {
            std::vector<LowCorridor> others = corridors;
            others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
            if (separate(others, problem, reading)) corridors = std::move(others);
        }
    }
    std::erase_if(corridors, [&](const LowCorridor& corridor) {
        return corridor.height <= problem.requirements.tolerance;
    });
    return corridors;
}

/// Are start and goal of every ASV in one component of the free space?
Feasibility check_components(const Problem& problem) {
    // What is closed in the literal reading is closed in the intended one as well.
    const auto separated = find_separated(problem, Reading::intended);
    if (!separated) return {};
    const auto proven = find_separated(problem, Reading::literal);
    const std::string who = problem.body_kind() == BodyKind::point
                                ? "the point"
                                : "ASV " + std::to_string(proven.value_or(*separated) + 1);
    const std::string separate = "obstacles separate the start of " + who + " from its goal";
    if (proven) return {Infeasibility::separated, proven, separate};
    return {Infeasibility::separated_as_intended, separated, separate + but_for_tolerance};
}

/// Is there a way for the middle of the chain once the corridors are closed that are too low?
/// Precondition: the problem has bounds.
Feasibility check_low_corridors(const Problem& problem) {
    const std::vector<LowCorridor> corridors = find_low_corridors(problem);
    if (corridors.empty() || !separate(corridors, problem, Reading::intended)) return {};
    const bool proven = separate(corridors, problem, Reading::literal);
    const Reading reading = proven ? Reading::literal : Reading::intended;
    const std::vector<LowCorridor> in_the_way = decisive(corridors, problem, reading);
    const std::string reason = in_the_way.empty()
                                   ? "obstacles separate the middle of the chain from its goal"
                                   : describe(in_the_way, problem);
    const std::vector<Box> closed = closed_parts(in_the_way);
    if (proven) return {Infeasibility::corridor_too_low, std::nullopt, reason, closed};
    return {Infeasibility::separated_as_intended, std::nullopt, reason + but_for_tolerance, closed};
}

}  // namespace

Feasibility check_area(const Problem& problem) {
    if (problem.body_kind() != BodyKind::chain || !lacks_area(problem)) return {};
    return {Infeasibility::no_area, std::nullopt,
            "a chain of " + std::to_string(problem.asv_count()) +
                " ASVs cannot enclose the area that is required"};
}

Feasibility check_orientation(const Problem& problem) {
    if (problem.body_kind() != BodyKind::chain || !has_opposite_orientation(problem)) return {};
    const bool left = geometry::signed_area(problem.start) > 0;
    return {Infeasibility::opposite_orientation, std::nullopt,
            std::string("the chain turns ") + (left ? "left" : "right") + " at the start and " +
                (left ? "right" : "left") +
                " at the goal; in between it would have to enclose no area"};
}

Feasibility check_separation(const Problem& problem) {
    if (problem.body_kind() == BodyKind::arm) return {};
    const Feasibility of_asvs = check_components(problem);
    if (of_asvs.proven_infeasible()) return of_asvs;
    const Feasibility of_middle = check_low_corridors(bounded(problem));
    const bool says_more = of_middle.proven_infeasible() || of_asvs.cause == Infeasibility::none;
    return says_more ? of_middle : of_asvs;
}

Feasibility check_passages(const Problem& problem) {
    constexpr std::size_t most_cells = 200'000;
    return PassageCheck(bounded(problem)).work(most_cells);
}

Feasibility check_feasibility(const Problem& problem) {
    for (const auto& check : {check_area, check_orientation, check_separation}) {
        Feasibility found = check(problem);
        if (found.cause != Infeasibility::none) return found;
    }
    return {};
}

}  // namespace asv::core
