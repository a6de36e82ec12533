#include "core/solve/planning_frame.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/model/planning_window.hpp"
#include "geometry/predicates/polygon.hpp"

namespace asv::core {

namespace {

/// Calls change(point) for every point that the problem is made of.
template <class Change>
void for_each_point(Problem& problem, Change&& change) {
    for (auto* state : {&problem.start, &problem.goal})
        for (Point& point : *state) change(point);
    for (Box& box : problem.obstacles) {
        change(box.low);
        change(box.high);
    }
    change(problem.requirements.bounds.low);
    change(problem.requirements.bounds.high);
}

void reverse(Problem& problem) {
    std::swap(problem.start, problem.goal);
    if (auto* arm = std::get_if<PlanarArm>(&problem.body)) std::swap(arm->start, arm->goal);
}

/// The power of two nearest to the length of a unit in which brooms are as long as in the public
/// assignment; 1 for other bodies.
double planning_unit(const Problem& problem) {
    if (problem.body_kind() != BodyKind::chain) return 1;
    constexpr double usual_length = Requirements{}.broom_length;
    constexpr double root_of_half = 0x1.6a09e667f3bcdp-1;
    int exponent;
    const double mantissa = std::frexp(problem.requirements.broom_length / usual_length, &exponent);
    return std::ldexp(1, mantissa < root_of_half ? exponent - 1 : exponent);
}

/// Tolerances and steps are lengths as well.
void scale(Problem& problem, double factor) {
    for_each_point(problem, [factor](Point& point) {
        point.x *= factor;
        point.y *= factor;
    });
    Requirements& required = problem.requirements;
    for (double* length : {&required.broom_length, &required.max_step,
                           &required.area_radius_per_broom, &required.tolerance})
        *length *= factor;
}

void transpose(Problem& problem) {
    for_each_point(problem, [](Point& point) { std::swap(point.x, point.y); });
}

bool turns_clockwise(const Problem& problem) {
    return problem.body_kind() == BodyKind::chain && geometry::signed_area(problem.start) < 0;
}

}  // namespace

PlanningFrame::PlanningFrame(const Problem& given, bool reversed)
    : reversed_(reversed),
      unit_(planning_unit(given)),
      transposed_(turns_clockwise(given)),
      problem_(bounded(given)) {
    if (reversed_) reverse(problem_);
    if (unit_ != 1) scale(problem_, 1 / unit_);
    if (transposed_) transpose(problem_);
}

Point PlanningFrame::point_back(const Point& point) const {
    const double x = unit_ * point.x, y = unit_ * point.y;
    return transposed_ ? Point{y, x} : Point{x, y};
}

Path PlanningFrame::path_in(const Path& given) const {
    Path planned(given.asv_count());
    planned.reserve(given.size());
    std::vector<Point> state(given.asv_count());
    for (std::size_t i = 0; i < given.size(); ++i) {
        const auto from = given.state(reversed_ ? given.size() - 1 - i : i);
        std::transform(from.begin(), from.end(), state.begin(), [this](const Point& point) {
            const double x = point.x / unit_, y = point.y / unit_;
            return transposed_ ? Point{y, x} : Point{x, y};
        });
        planned.push_back(state);
    }
    return planned;
}

Path PlanningFrame::path_back(const Path& path) const {
    Path back(path.asv_count());
    back.reserve(path.size());
    std::vector<Point> state(path.asv_count());
    for (std::size_t i = 0; i < path.size(); ++i) {
        const auto planned = path.state(reversed_ ? path.size() - 1 - i : i);
        std::transform(planned.begin(), planned.end(), state.begin(),
                       [this](const Point& point) { return point_back(point); });
        back.push_back(state);
    }
    return back;
}

std::vector<Placement> PlanningFrame::placements_back(std::vector<Placement> placements) const {
    for (Placement& placement : placements)
        for (Point& point : placement.points) point = point_back(point);
    if (reversed_) std::reverse(placements.begin(), placements.end());
    return placements;
}

std::vector<TreePicture> PlanningFrame::trees_back(std::vector<TreePicture> trees) const {
    for (TreePicture& tree : trees) {
        for (Point& point : tree.points) point = point_back(point);
        if (reversed_ && tree.root != TreeRoot::roadmap)
            tree.root = tree.root == TreeRoot::start ? TreeRoot::goal : TreeRoot::start;
    }
    if (reversed_) std::reverse(trees.begin(), trees.end());
    return trees;
}

}  // namespace asv::core
