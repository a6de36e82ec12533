#include "core/bounds/passages/gate_check.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "core/bounds/asv_plane.hpp"
#include "core/bounds/corridors/low_corridors.hpp"
#include "core/bounds/walls.hpp"
#include "geometry/free_plane/gates.hpp"

namespace asv::core {

namespace {

/// Cells of the plane that the search for one shortest way may enter, each as often as it is.
constexpr std::size_t effort_for_way = 100'000;
/// Cells of chains after which a section counts as open: a second or so.
constexpr std::size_t most_cells_of_section = 400'000;
/// Of a section, in primitive steps: hardly anything.
constexpr double thickness = 1e-3;
/// Beyond so many closed parts it is not asked without which there is a way.
constexpr std::size_t most_to_leave_out = 30;
/// Pairs of obstacles that gates are looked for between in the time that a cell of chains takes.
constexpr std::size_t pairs_for_a_cell = 100;

double narrow_side(const geometry::Gate& gate) {
    const auto& [low, high] = gate.gap;
    return std::min(high.x - low.x, high.y - low.y);
}

}  // namespace

GateCheck::GateCheck(const TurnedLeft& turned) : turned_(turned) {
    const Problem& problem = turned_.problem;
    const Requirements& requirements = problem.requirements;
    for (std::size_t i = 0; i < problem.obstacles.size(); ++i) {
        const Box wall = shrunk(problem.obstacles[i], shrink_for_steps(requirements), requirements);
        if (vanishes(wall)) continue;
        walls_.push_back(wall);
        obstacle_of_wall_.push_back(i);
    }
    for (const LowCorridor& corridor : find_low_corridors(problem)) {
        const bool upright = corridor.upright != turned_.transposed;
        closed_.push_back({corridor.closed, place_of(corridor.walls, upright),
                           corridor.height <= requirements.tolerance});
    }
}

std::vector<Box> GateCheck::closed() const {
    std::vector<Box> boxes;
    for (const ClosedPart& part : closed_) boxes.push_back(part.closed);
    return boxes;
}

void GateCheck::work(std::size_t& cells) {
    while (cells > 0 && !finished_) {
        if (waiting_.empty()) look_for_sections(cells);
        finished_ = waiting_.empty();
        if (!finished_ && cells > 0) examine_next(cells);
    }
}

/// The sections of the gates on the shortest way, the narrowest next. None where there is no way,
/// or one with all its gates examined.
void GateCheck::look_for_sections(std::size_t& cells) {
    cells -= std::min(cells, walls_.size() * walls_.size() / pairs_for_a_cell);
    proven_ = separate(closed_);
    if (proven_) return;
    const Problem& problem = turned_.problem;
    const std::vector<Point> way =
        make_middle_plane(problem, closed())
            .shortest_path_points(middle_of_chain(problem.start), middle_of_chain(problem.goal),
                                  effort_for_way);
    auto gates = geometry::gates_on_way(way, walls_, widened_bounds(problem.requirements));
    std::sort(gates.begin(), gates.end(),
              [](const auto& a, const auto& b) { return narrow_side(a) > narrow_side(b); });
    for (const geometry::Gate& gate : gates) {
        auto sections = sections_of(gate, walls_, thickness * problem.requirements.max_step);
        std::reverse(sections.begin(), sections.end());
        for (const GateSection& section : sections)
            if (std::ranges::find(examined_, section) == examined_.end())
                waiting_.push_back(section);
    }
}

/// Makes a wall of the section if it is empty: there will be another shortest way then.
void GateCheck::examine_next(std::size_t& cells) {
    const GateSection section = waiting_.back();
    if (!region_) {
        // Half a step, and the tolerance for what rounding loses.
        const double more = shrink_for_steps(turned_.problem.requirements);
        region_.emplace(turned_.problem, grown(section.across, more), most_cells_of_section);
    }
    const EmptyRegion::Answer answer = region_->examine(cells);
    if (answer == EmptyRegion::Answer::unknown) return;
    region_.reset();
    waiting_.pop_back();
    examined_.push_back(section);
    if (answer != EmptyRegion::Answer::empty) return;
    closed_.push_back({section.across, place_of_gate(section), is_slit(section)});
    waiting_.clear();
}

/// Do these parts keep the middle of the chain from its goal?
bool GateCheck::separate(const std::vector<ClosedPart>& parts) const {
    std::vector<Box> closed;
    for (const ClosedPart& part : parts) closed.push_back(part.closed);
    geometry::FreePlane plane = make_middle_plane(turned_.problem, closed);
    const Point start = middle_of_chain(turned_.problem.start);
    const Point goal = middle_of_chain(turned_.problem.goal);
    return plane.is_free(start) && plane.is_free(goal) && !plane.connected(start, goal);
}

bool GateCheck::is_slit(const GateSection& section) const {
    const auto obstacle = [&](std::size_t side) {
        return turned_.problem.obstacles[obstacle_of_wall_[side]];
    };
    const auto [a, b] = section.sides;
    const Box first = grown(obstacle(a), turned_.problem.requirements.tolerance);
    if (b < walls_.size()) return geometry::overlap(first, obstacle(b));
    const Box& bounds = turned_.problem.requirements.bounds;
    const std::array beyond{first.low.x<bounds.low.x, first.high.x> bounds.high.x,
                            first.low.y<bounds.low.y, first.high.y> bounds.high.y};
    return beyond[b - walls_.size()];
}

/// "left", "right", "lower" or "upper", as the user sees it.
std::string GateCheck::name_of_border(std::size_t number) const {
    constexpr std::array names{"left", "right", "lower", "upper"};
    constexpr std::array transposed_names{"lower", "upper", "left", "right"};
    return turned_.transposed ? transposed_names[number] : names[number];
}

std::string GateCheck::place_of_gate(const GateSection& section) const {
    const auto [a, b] = section.sides;
    const std::size_t first = obstacle_of_wall_[a] + 1;
    if (b >= walls_.size())
        return "between obstacle " + std::to_string(first) + " and the " +
               name_of_border(b - walls_.size()) + " border";
    return "between obstacles " + std::to_string(first) + " and " +
           std::to_string(obstacle_of_wall_[b] + 1);
}

/// Those without which there would be a way, all where they are too many to try; and no slits.
std::vector<GateCheck::ClosedPart> GateCheck::decisive_parts() const {
    std::vector<ClosedPart> parts = closed_;
    for (std::size_t i = parts.size(); i-- > 0 && closed_.size() <= most_to_leave_out;) {
        std::vector<ClosedPart> others = parts;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        if (separate(others)) parts = std::move(others);
    }
    std::erase_if(parts, [](const ClosedPart& part) { return part.slit; });
    return parts;
}

Feasibility GateCheck::conclusion() const {
    Feasibility found;
    found.cause = Infeasibility::gates_closed;
    const std::vector<ClosedPart> parts = decisive_parts();
    if (parts.empty()) {
        found.reason = "obstacles separate the middle of the chain from its goal";
        return found;
    }
    found.reason =
        "no chain of " + std::to_string(turned_.problem.asv_count()) + " ASVs can have its middle ";
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (i > 0) found.reason += i + 1 < parts.size() ? ", " : " or ";
        found.reason += parts[i].place;
        found.closed.push_back(turned_.back(parts[i].closed));
    }
    found.reason += ", and there is no other way";
    return found;
}

}  // namespace asv::core
