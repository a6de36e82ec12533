#include "core/solve/prepared_world.hpp"

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/chain/arm_kinematics.hpp"
#include "core/solve/planning_obstacles.hpp"

namespace asv::core {

namespace {

void require_count(std::size_t given, std::size_t wanted, const char* end, const char* what) {
    if (given == wanted) return;
    throw std::invalid_argument(std::string(end) + ": " + std::to_string(given) + ' ' + what +
                                " for a body of " + std::to_string(wanted));
}

/// The points of the end of an arm, whose angles become those given.
std::vector<Point> arm_end(const PlanarArm& arm, const Point& base, const char* end,
                           std::vector<double>& own, const std::vector<double>& given) {
    require_count(given.size(), arm.links.size(), end, "joint angles");
    for (std::size_t i = 0; i < given.size(); ++i) {
        const JointRange& range = arm.joints[i];
        if (!range.wraps && !(given[i] >= range.low && given[i] <= range.high))
            throw std::invalid_argument(std::string(end) + ": the angle of joint " +
                                        std::to_string(i + 1) + " is out of its range");
    }
    own = given;
    return arm_points(arm, base, own);
}

}  // namespace

PreparedWorld::PreparedWorld(Problem problem)
    : problem_(std::move(problem)), obstacles_(std::make_unique<PlanningObstacles>()) {
    if (problem_.start.empty()) throw std::invalid_argument("start: no points");
    require_count(problem_.goal.size(), problem_.start.size(), "goal", "points");
    obstacles_->in(PlanningFrame(problem_));
}

PreparedWorld::PreparedWorld(PreparedWorld&&) noexcept = default;
PreparedWorld& PreparedWorld::operator=(PreparedWorld&&) noexcept = default;
PreparedWorld::~PreparedWorld() = default;

Problem PreparedWorld::problem_of(const WorldQuery& query) const {
    Problem problem = problem_;
    const Point base = problem.start[0];
    auto* arm = std::get_if<PlanarArm>(&problem.body);
    const auto put = [&](const Placement& given, const char* end, std::vector<Point>& points,
                         std::vector<double>* angles) {
        if (given.empty()) return;
        if (angles) {
            points = arm_end(*arm, base, end, *angles, given.angles);
        } else {
            require_count(given.points.size(), points.size(), end, "points");
            points = given.points;
        }
    };
    put(query.start, "start", problem.start, arm ? &arm->start : nullptr);
    put(query.goal, "goal", problem.goal, arm ? &arm->goal : nullptr);
    return problem;
}

SolveResult PreparedWorld::solve(const WorldQuery& query, const SolveOptions& options) const {
    return solve_among(obstacles_.get(), nullptr, problem_of(query), options);
}

}  // namespace asv::core
