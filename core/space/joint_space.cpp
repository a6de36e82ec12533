#include "core/space/joint_space.hpp"

#include <cmath>

#include "core/search/trees/interpolate.hpp"

namespace asv::core {

namespace {

/// Draws until one is valid; then the space is too crowded for drawing whole configurations.
constexpr int max_draws = 1000;

}  // namespace

JointSpace::JointSpace(const JointWorld& world)
    : world_(world),
      checker_(world.make_checker()),
      from_(world.chain.dimension()),
      to_(world.chain.dimension()),
      drawn_(world.dimension()),
      pose_(world.chain.make_pose()) {}

NearestNeighbours JointSpace::make_index() const {
    return {std::vector<double>(dimension(), 1.0), wrapping()};
}

double JointSpace::distance(std::span<const double> a, std::span<const double> b) const {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return std::sqrt(sum);
}

bool JointSpace::sample(Rng& rng, std::span<double> row) {
    for (int draw = 0; draw < max_draws; ++draw) {
        for (double& coordinate : drawn_) coordinate = rng.uniform();
        if (from_unit_cube(drawn_, row) && valid(row)) return true;
    }
    return false;
}

Steered JointSpace::steer(std::span<const double> from, std::span<const double> target,
                          Configurations& visited) {
    world_.chain_row(from, from_);
    world_.chain_row(target, to_);
    const double step = world_.problem.requirements.max_step;
    const double proven =
        world_.within_limits(target) ? checker_.valid_prefix(from_, to_, step) : -1;
    if (proven >= 1) {
        visited.insert(visited.end(), target.begin(), target.end());
        return Steered::reached;
    }
    if (proven <= 0 || checker_.speed_bound() * proven < step) return Steered::trapped;
    for (std::size_t i = 0; i < from.size(); ++i)
        visited.push_back(from[i] + proven * (target[i] - from[i]));
    return Steered::advanced;
}

bool JointSpace::from_unit_cube(std::span<const double> cube, std::span<double> row) const {
    for (std::size_t i = 0; i < row.size(); ++i) {
        const JointCoordinate& c = world_.coordinates[i];
        row[i] = c.low + cube[i] * (c.high - c.low);
    }
    return true;
}

double JointSpace::extent(std::size_t coordinate) const {
    const JointCoordinate& c = world_.coordinates[coordinate];
    return c.high - c.low;
}

void JointSpace::perturb(Rng& rng, std::span<const double> row, double sigma,
                         std::span<double> out) const {
    for (std::size_t i = 0; i < row.size(); ++i) out[i] = row[i] + sigma * rng.normal();
}

bool JointSpace::collides(std::span<const double> row) {
    world_.chain_row(row, to_);
    return !checker_.valid(to_);
}

bool JointSpace::valid(std::span<const double> row) {
    return world_.within_limits(row) && !collides(row);
}

bool JointSpace::motion_valid(std::span<const double> from, std::span<const double> to) {
    if (!world_.within_limits(from) || !world_.within_limits(to)) return false;
    world_.chain_row(from, from_);
    world_.chain_row(to, to_);
    return checker_.valid(from_, to_);
}

geometry::Point JointSpace::position(std::span<const double> row) {
    world_.chain_row(row, to_);
    world_.chain.forward(to_, pose_);
    return {pose_.x.back(), pose_.y.back()};
}

}  // namespace asv::core
