#include "tests/kit/chains/problems.hpp"

#include <algorithm>
#include <utility>

#include "geometry/predicates/distance.hpp"
#include "io/problem/problem_file.hpp"

namespace asv::test {

core::Problem problem(Points start, Points goal, std::vector<Box> obstacles) {
    core::Problem result;
    result.start = std::move(start);
    result.goal = std::move(goal);
    result.obstacles = std::move(obstacles);
    return result;
}

core::Problem mirrored(core::Problem problem) {
    for (auto* state : {&problem.start, &problem.goal})
        for (Point& point : *state) point.x = 1 - point.x;
    for (Box& box : problem.obstacles)
        box = {{1 - box.high.x, box.low.y}, {1 - box.low.x, box.high.y}};
    return problem;
}

core::Problem transposed(core::Problem problem) {
    for (auto* state : {&problem.start, &problem.goal})
        for (Point& point : *state) std::swap(point.x, point.y);
    for (Box& box : problem.obstacles) box = geometry::transposed(box);
    return problem;
}

core::Problem reversed(core::Problem problem) {
    std::swap(problem.start, problem.goal);
    return problem;
}

std::vector<Box> clutter(core::Rng& rng, std::size_t count, double size,
                         const core::Problem& around) {
    constexpr double room = 0.003;
    const auto meets = [&](const Points& chain, const Box& box) {
        const std::size_t last = chain.size() - 1;
        for (std::size_t i = 0; i <= last; ++i) {
            const geometry::Segment broom{chain[i], chain[std::min(i + 1, last)]};
            if (geometry::distance(broom, box) < room) return true;
        }
        return false;
    };
    std::vector<Box> boxes;
    while (boxes.size() < count) {
        const Point low{rng.uniform(-0.05, 1), rng.uniform(-0.05, 1)};
        const Box box{low, {low.x + rng.uniform(0.01, size), low.y + rng.uniform(0.01, size)}};
        if (!meets(around.start, box) && !meets(around.goal, box)) boxes.push_back(box);
    }
    return boxes;
}

core::Problem cluttered(core::Rng& rng, std::size_t n, std::size_t count, double size) {
    core::Problem result = problem(ring(n, {0.2, 0.2}, 1), ring(n, {0.8, 0.8}, 2));
    result.obstacles = clutter(rng, count, size, result);
    return result;
}

std::string testcase_file(const std::string& name) {
    return std::string(ASV_SOURCE_DIR) + "/testcases/" + name;
}

core::Problem testcase(const std::string& name) {
    return io::read_problem(testcase_file(name)).problem;
}

}  // namespace asv::test
