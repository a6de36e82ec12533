#include "tests/kit/files/random_files.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "io/text/scanner.hpp"

namespace asv::test {

namespace {

Point random_point(Random& random) {
    const double x = random_number(random);
    return {x, random_number(random)};
}

}  // namespace

double random_number(Random& random) {
    if (random.one_in(2)) return random.uniform(0, 1);
    while (true) {
        const double value = std::bit_cast<double>(random.bits());
        if (std::isfinite(value) && std::abs(value) <= io::largest_number) return value;
    }
}

Points random_points(Random& random, std::size_t count) {
    Points points;
    for (std::size_t i = 0; i < count; ++i) points.push_back(random_point(random));
    return points;
}

core::Problem random_problem(Random& random) {
    const std::size_t asv_count = 1 + random.below(6);
    core::Problem problem;
    problem.start = random_points(random, asv_count);
    problem.goal = random_points(random, asv_count);
    for (std::size_t i = random.below(5); i > 0; --i) {
        const Point a = random_point(random), b = random_point(random);
        problem.obstacles.push_back(geometry::bounds(geometry::Segment{a, b}));
    }
    return problem;
}

core::Solution random_solution(Random& random, std::size_t asv_count) {
    core::Solution solution{core::Path(asv_count), random_number(random)};
    for (std::size_t i = 1 + random.below(8); i > 0; --i) {
        solution.path.push_back(random_points(random, asv_count));
    }
    return solution;
}

}  // namespace asv::test
