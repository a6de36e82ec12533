#include "tests/core/trajectory/sample_paths.hpp"

#include <cmath>
#include <functional>
#include <numbers>

namespace asv::test {

namespace {

/// The states that follow the first one, each moved by a turn and a length of each vehicle.
core::Path wander(Random& random, std::size_t vehicles, std::size_t steps,
                  const std::function<double()>& turn, const std::function<double()>& length) {
    Points state;
    std::vector<double> headings;
    for (std::size_t i = 0; i < vehicles; ++i) {
        state.push_back({random.uniform(0, 1), random.uniform(0, 1)});
        headings.push_back(random.uniform(-std::numbers::pi, std::numbers::pi));
    }
    core::Path path(vehicles);
    path.push_back(state);
    for (std::size_t k = 0; k < steps; ++k) {
        for (std::size_t i = 0; i < vehicles; ++i) {
            headings[i] += turn();
            const double far = length();
            state[i].x += far * std::cos(headings[i]);
            state[i].y += far * std::sin(headings[i]);
        }
        path.push_back(state);
    }
    return path;
}

}  // namespace

core::Path straight_run(std::size_t vehicles, std::size_t steps, double step) {
    core::Path path(vehicles);
    for (std::size_t k = 0; k <= steps; ++k) {
        Points state;
        for (std::size_t i = 0; i < vehicles; ++i)
            state.push_back({static_cast<double>(k) * step, static_cast<double>(i)});
        path.push_back(state);
    }
    return path;
}

core::Path beside_a_resting_one(const core::Path& path) {
    core::Path more(path.asv_count() + 1);
    for (std::size_t k = 0; k < path.size(); ++k) {
        const auto state = path.state(k);
        Points with(state.begin(), state.end());
        with.push_back({3, 4});
        more.push_back(with);
    }
    return more;
}

core::Path circle(double radius, std::size_t steps) {
    core::Path path(1);
    for (std::size_t k = 0; k <= steps; ++k) {
        const double angle =
            2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(steps);
        path.push_back(Points{{radius * std::cos(angle), radius * std::sin(angle)}});
    }
    return path;
}

core::Path around_a_corner(std::size_t steps, double step) {
    core::Path path = straight_run(1, steps, step);
    const double corner = path.state(steps)[0].x;
    for (std::size_t k = 1; k <= steps; ++k)
        path.push_back(Points{{corner, static_cast<double>(k) * step}});
    return path;
}

core::Path winding_path(Random& random, std::size_t vehicles, std::size_t steps) {
    return wander(
        random, vehicles, steps, [&] { return random.uniform(-0.05, 0.05); },
        [&] { return random.uniform(0.0007, 0.001); });
}

core::Path wild_path(Random& random, std::size_t vehicles, std::size_t steps) {
    return wander(
        random, vehicles, steps, [&] { return random.uniform(-4, 4); },
        [&] { return random.one_in(4) ? 0 : std::pow(10, random.uniform(-9, 0)); });
}

core::Path reversed(const core::Path& path) {
    core::Path back(path.asv_count());
    for (std::size_t k = path.size(); k-- > 0;) back.push_back(path.state(k));
    return back;
}

}  // namespace asv::test
