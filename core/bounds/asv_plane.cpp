#include "core/bounds/asv_plane.hpp"

#include <algorithm>
#include <span>
#include <vector>

#include "core/bounds/seams.hpp"
#include "core/bounds/walls.hpp"
#include "core/model/planning_window.hpp"
#include "geometry/predicates/segment_box.hpp"

namespace asv::core {

namespace {

bool body_meets(std::span<const Point> state, const Box& box) {
    if (state.size() == 1) return geometry::contains(box, state[0]);
    for (std::size_t i = 0; i + 1 < state.size(); ++i) {
        if (geometry::meets({state[i], state[i + 1]}, box)) return true;
    }
    return false;
}

}  // namespace

geometry::FreePlane make_asv_plane(const Problem& given, Reading reading,
                                   std::span<const Box> closed) {
    const Problem problem = bounded(given);
    const Requirements& requirements = problem.requirements;
    const double e = requirements.tolerance;
    const double shrink = reading == Reading::literal ? shrink_for_steps(requirements) : e + e / 2;
    const bool collides = problem.asv_count() > 1 || problem.body_kind() == BodyKind::point;
    if (!collides) return {{}, widened_bounds(requirements)};
    // The seams first: finding them takes most of the memory, and is done before there is more.
    const std::vector<Seam> seams = find_seams(problem, shrink);
    ShrunkObstacles obstacles = shrink_obstacles(problem, shrink);
    for (const Seam& seam : seams) {
        if (reading == Reading::literal && !is_impassable(seam, problem)) continue;
        if (body_meets(problem.start, seam.gap) || body_meets(problem.goal, seam.gap)) continue;
        obstacles.boxes.push_back(seam.gap);
    }
    obstacles.boxes.insert(obstacles.boxes.end(), closed.begin(), closed.end());
    return {obstacles.boxes, obstacles.bounds};
}

geometry::FreePlane make_middle_plane(const Problem& problem, std::span<const Box> closed) {
    ShrunkObstacles walls = shrink_obstacles(problem, shrink_for_steps(problem.requirements));
    walls.boxes.insert(walls.boxes.end(), closed.begin(), closed.end());
    return {walls.boxes, walls.bounds};
}

}  // namespace asv::core
