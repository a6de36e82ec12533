#include "core/routes/ways.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/bounds/asv_plane.hpp"
#include "geometry/free_plane/gates.hpp"

namespace asv::core {

namespace {

/// Gates are looked for among all pairs of boxes, which are too many beyond this.
constexpr std::size_t max_boxes = 200;
/// Cells that the search for one shortest way may enter, each as often as it is.
constexpr std::size_t effort = 10'000;
/// A gate is closed by a box that is at least so thick.
constexpr double min_thickness = 1e-3;
/// Microseconds that a class takes for each box and for each ASV, and its gates for each pair of
/// boxes.
constexpr double work_for_box = 8, work_for_asv = 3, work_for_pair = 0.3;

Box thickened(Box box) {
    const auto thicken = [](double& low, double& high) {
        const double lacking = std::max(0.0, min_thickness - (high - low));
        low -= lacking / 2;
        high += lacking / 2;
    };
    thicken(box.low.x, box.high.x);
    thicken(box.low.y, box.high.y);
    return box;
}

/// May a broom of the state meet the box?
bool is_near(std::span<const Point> state, const Box& box) {
    for (std::size_t i = 0; i + 1 < state.size(); ++i) {
        const geometry::Segment broom{state[i], state[i + 1]};
        if (geometry::overlap(geometry::bounds(broom), box)) return true;
    }
    return false;
}

}  // namespace

Problem with_closed_gates(Problem problem, const std::vector<Box>& closed) {
    problem.obstacles.insert(problem.obstacles.end(), closed.begin(), closed.end());
    return problem;
}

Ways::Ways(const Problem& problem) : problem_(problem) {
    if (problem.obstacles.size() <= max_boxes)
        add({});
    else
        waiting_.push_back({});
}

std::optional<Way> Ways::next() {
    if (last_) make_others_of(*last_);
    last_.reset();
    if (waiting_.empty()) return std::nullopt;
    const auto least =
        std::min_element(waiting_.begin(), waiting_.end(),
                         [](const Way& a, const Way& b) { return a.bound < b.bound; });
    last_ = std::move(*least);
    waiting_.erase(least);
    return last_;
}

/// Closes each gate of its shortest way in turn.
void Ways::make_others_of(const Way& way) {
    const Problem world = with_closed_gates(problem_, way.closed);
    const auto boxes = static_cast<double>(world.obstacles.size());
    work_ += work_for_pair * boxes * boxes / 2;
    std::vector<Box> kept_open = way.kept_open;
    for (const auto& [gap, sides] :
         geometry::gates_on_way(way.bends, world.obstacles, world.requirements.bounds)) {
        const Box closing = thickened(gap);
        if (std::find(kept_open.begin(), kept_open.end(), gap) != kept_open.end() ||
            is_near(problem_.start, closing) || is_near(problem_.goal, closing))
            continue;
        Way other;
        other.closed = way.closed;
        other.closed.push_back(closing);
        other.kept_open = kept_open;
        add(std::move(other));
        kept_open.push_back(gap);
    }
}

/// Finds the bound and the shortest way of a class, and keeps it where it leads to the goal.
void Ways::add(Way way) {
    const Problem world = with_closed_gates(problem_, way.closed);
    work_ += work_for_box * static_cast<double>(world.obstacles.size()) +
             work_for_asv * static_cast<double>(world.asv_count());
    geometry::FreePlane plane = make_asv_plane(world, Reading::intended);
    for (std::size_t i = 0; i < world.asv_count(); ++i)
        way.bound += plane.shortest_path_at_least(world.start[i], world.goal[i], effort);
    if (!std::isfinite(way.bound)) return;
    const std::size_t middle = world.asv_count() / 2;
    way.bends = plane.shortest_path_points(world.start[middle], world.goal[middle], effort);
    waiting_.push_back(std::move(way));
}

}  // namespace asv::core
