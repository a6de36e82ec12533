#include "core/bounds/walls.hpp"

#include <algorithm>
#include <cmath>

namespace asv::core {

double rounding_slack(const Requirements& requirements) {
    const Box& bounds = requirements.bounds;
    const double largest = std::max({std::abs(bounds.low.x), std::abs(bounds.low.y),
                                     std::abs(bounds.high.x), std::abs(bounds.high.y)});
    return 1e-4 * requirements.tolerance + 1e-15 * largest;
}

Box widened_bounds(const Requirements& requirements) {
    return grown(requirements.bounds, requirements.tolerance + rounding_slack(requirements));
}

double shrink_for_steps(const Requirements& requirements) {
    const double step = requirements.max_step + requirements.tolerance;
    return requirements.tolerance + step / 2;
}

Box shrunk(const Box& box, double shrink, const Requirements& requirements) {
    return grown(box, -(shrink + rounding_slack(requirements)));
}

bool vanishes(const Box& box) {
    return box.low.x >= box.high.x || box.low.y >= box.high.y;
}

std::vector<Wall> outside(const Requirements& requirements) {
    const Box& bounds = requirements.bounds;
    const Box widened = widened_bounds(requirements);
    const double far = bounds.high.x - bounds.low.x + bounds.high.y - bounds.low.y;
    std::vector<Wall> walls(4, {grown(bounds, far), grown(widened, far)});
    walls[0].whole.high.x = bounds.low.x;
    walls[0].shrunk.high.x = widened.low.x;
    walls[1].whole.low.x = bounds.high.x;
    walls[1].shrunk.low.x = widened.high.x;
    walls[2].whole.high.y = bounds.low.y;
    walls[2].shrunk.high.y = widened.low.y;
    walls[3].whole.low.y = bounds.high.y;
    walls[3].shrunk.low.y = widened.high.y;
    return walls;
}

}  // namespace asv::core
