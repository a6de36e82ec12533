#include "tests/kit/chains/arms.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/predicates/segment_box.hpp"

namespace asv::test {

core::PlanarArm random_arm(core::Rng& rng) {
    core::PlanarArm arm;
    const std::size_t n = 1 + rng.below(6);
    for (std::size_t i = 0; i < n; ++i) {
        arm.links.push_back(rng.uniform(0.05, 0.3));
        arm.joints.push_back({rng.chance(0.5), -std::numbers::pi, std::numbers::pi});
        arm.start.push_back(rng.uniform(-std::numbers::pi, std::numbers::pi));
        arm.goal.push_back(rng.uniform(-std::numbers::pi, std::numbers::pi));
    }
    arm.angles =
        rng.chance(0.5) ? core::AngleReference::x_axis : core::AngleReference::previous_link;
    return arm;
}

Points textbook(const core::PlanarArm& arm, const Point& base, std::span<const double> angles) {
    Points points{base};
    double heading = 0;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        heading = arm.angles == core::AngleReference::x_axis ? angles[i] : heading + angles[i];
        points.push_back({points.back().x + arm.links[i] * std::cos(heading),
                          points.back().y + arm.links[i] * std::sin(heading)});
    }
    return points;
}

bool collides(const Points& points, const std::vector<geometry::Box>& boxes) {
    for (const geometry::Box& box : boxes) {
        if (points.size() == 1 && geometry::contains(box, points[0])) return true;
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            if (geometry::meets({points[i], points[i + 1]}, box)) return true;
    }
    return false;
}

core::Problem arm_problem(core::Rng& rng) {
    core::Problem problem;
    core::PlanarArm arm = random_arm(rng);
    const Point base{rng.uniform(), rng.uniform()};
    problem.start = textbook(arm, base, arm.start);
    problem.goal = textbook(arm, base, arm.goal);
    problem.body = std::move(arm);
    problem.requirements.bounds =
        rng.chance(0.5) ? core::without_bounds() : geometry::Box{{-2, -2}, {3, 3}};
    while (problem.obstacles.size() < 15) {
        const Point low{rng.uniform(-0.5, 1.5), rng.uniform(-0.5, 1.5)};
        const geometry::Box box{low,
                                {low.x + rng.uniform(0.01, 0.2), low.y + rng.uniform(0.01, 0.2)}};
        const std::vector<geometry::Box> grown{geometry::grown(box, 0.001)};
        if (!collides(problem.start, grown) && !collides(problem.goal, grown))
            problem.obstacles.push_back(box);
    }
    return problem;
}

}  // namespace asv::test
