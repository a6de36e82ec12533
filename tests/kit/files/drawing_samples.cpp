#include "tests/kit/files/drawing_samples.hpp"

#include <cmath>
#include <utility>

namespace asv::test {

Points wide_arc(std::size_t asv_count, Point place) {
    return arc(asv_count, place, 0, 4.2 / static_cast<double>(asv_count));
}

core::Solution translated_arc(std::size_t asv_count, const Points& way, double step) {
    core::Solution solution{core::Path(asv_count), 0};
    solution.path.push_back(wide_arc(asv_count, way.front()));
    for (std::size_t i = 1; i < way.size(); ++i) {
        const double length = std::hypot(way[i].x - way[i - 1].x, way[i].y - way[i - 1].y);
        const auto count = static_cast<std::size_t>(std::ceil(length / step));
        for (std::size_t k = 1; k <= count; ++k) {
            const double t = static_cast<double>(k) / static_cast<double>(count);
            solution.path.push_back(wide_arc(asv_count, {std::lerp(way[i - 1].x, way[i].x, t),
                                                         std::lerp(way[i - 1].y, way[i].y, t)}));
        }
        solution.cost += length * static_cast<double>(asv_count);
    }
    return solution;
}

io::ExhibitInput sample(std::size_t asv_count, const Points& way, std::vector<Box> obstacles,
                        double step) {
    core::Solution solution = translated_arc(asv_count, way, step);
    io::ExhibitInput input;
    input.name = "sample";
    input.problem.start = wide_arc(asv_count, way.front());
    input.problem.goal = wide_arc(asv_count, way.back());
    input.problem.obstacles = std::move(obstacles);
    input.solution = std::move(solution);
    return input;
}

io::ExhibitInput low_corridor() {
    io::ExhibitInput input =
        sample(3, {{0.1, 0.3}, {0.8, 0.3}}, {{{0.4, 0}, {0.6, 0.5}}, {{0.4, 0.51}, {0.6, 1}}});
    input.solution.reset();
    return input;
}

std::vector<Box> two_walls() {
    return {{{0.4, 0}, {0.5, 0.2}}, {{0.4, 0.45}, {0.5, 1}}};
}

}  // namespace asv::test
