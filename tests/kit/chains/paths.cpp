#include "tests/kit/chains/paths.hpp"

#include <cmath>
#include <cstddef>

namespace asv::test {

core::Path path_of(const std::vector<Points>& states) {
    core::Path path(states.front().size());
    for (const Points& state : states) path.push_back(state);
    return path;
}

double cost_of(const core::Path& path) {
    double total = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        for (std::size_t k = 0; k < path.asv_count(); ++k) {
            const Point& a = path.state(i - 1)[k];
            const Point& b = path.state(i)[k];
            total += std::hypot(b.x - a.x, b.y - a.y);
        }
    }
    return total;
}

Case case_of(const std::vector<Points>& states) {
    Case result;
    result.problem.start = states.front();
    result.problem.goal = states.back();
    result.solution.path = path_of(states);
    result.solution.cost = cost_of(result.solution.path);
    return result;
}

}  // namespace asv::test
