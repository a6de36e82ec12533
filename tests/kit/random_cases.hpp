#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <random>
#include <vector>

#include "tests/kit/sample_chains.hpp"

/// Random chains and obstacles, many of them near one limit or another.

namespace asv::test {

inline int scaled(int count) {
    const char* scale = std::getenv("ASV_TEST_SCALE");
    return scale == nullptr ? count : static_cast<int>(count * std::atof(scale));
}

inline double uniform(std::mt19937_64& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// A chain of n >= 2 ASVs anywhere in the field, whose turns have one sign and add up to less than
/// a full turn; some joints are straight.
inline Chain random_chain(std::mt19937_64& random, std::size_t n) {
    std::vector<double> turns(n - 2);
    double sum = 0;
    for (double& turn : turns) {
        turn = random() % 5 == 0 ? 0 : -std::log(uniform(random, 0.01, 1));
        sum += turn;
    }
    const double total = uniform(random, 0.5, 1.9 * std::numbers::pi);
    const double sign = random() % 2 == 0 ? 1 : -1;
    for (double& turn : turns) turn *= sum > 0 ? sign * total / sum : 0;
    return chain_with_turns({uniform(random, 0, 1), uniform(random, 0, 1)}, uniform(random, -4, 4),
                            turns);
}

inline void shake(std::mt19937_64& random, Chain& chain, double size) {
    for (Point& point : chain) {
        point.x += uniform(random, -size, size);
        point.y += uniform(random, -size, size);
    }
}

inline core::Path path_of(const std::vector<Chain>& states) {
    core::Path path(states.front().size());
    for (const Chain& state : states) path.push_back(state);
    return path;
}

/// Boxes of any size up to `largest`, some of them as thin as twice the tolerance.
inline std::vector<geometry::Box> random_boxes(std::mt19937_64& random, std::size_t count,
                                               double largest) {
    std::vector<geometry::Box> boxes;
    for (std::size_t i = 0; i < count; ++i) {
        const Point low{uniform(random, -0.1, 1), uniform(random, -0.1, 1)};
        const auto side = [&] {
            return random() % 8 == 0 ? uniform(random, 1.5e-5, 2.5e-5)
                                     : uniform(random, 0, largest);
        };
        const double width = side();
        boxes.push_back({low, {low.x + width, low.y + side()}});
    }
    return boxes;
}

}  // namespace asv::test
