#include "core/space/straight_space.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/search/trees/interpolate.hpp"
#include "geometry/elementary/functions.hpp"

namespace asv::core {

namespace {

/// How near to what blocks it a straight motion ends, workspace units.
constexpr double resolution = 0.001;

/// The sharpest intermediate turn of start and goal.
double sharpest_turn(const ChainWorld& world) {
    double sharpest = 0;
    for (const auto* row : {&world.start, &world.goal})
        for (std::size_t i = 0; i < world.chain.turn_count(); ++i)
            sharpest = std::max(sharpest, (*row)[3 + i]);
    return sharpest;
}

}  // namespace

StraightSpace::StraightSpace(const ChainWorld& world, double widest_corridor)
    : world_(world),
      checker_(world.make_checker()),
      stepwise_(checker_, sharpest_turn(world)),
      pose_(world.chain.make_pose()),
      other_pose_(world.chain.make_pose()),
      widest_corridor_(widest_corridor),
      shapes_(checker_),
      cost_(world.chain),
      next_(world.chain.dimension()) {}

Steered StraightSpace::steer(std::span<const double> from, std::span<const double> target,
                             Configurations& visited) {
    const double proven = checker_.valid_prefix(from, target, resolution);
    if (proven < 1) {
        interpolate(from, target, std::max(proven, 0.0), next_);
        if (distance(from, next_) < resolution) return Steered::trapped;
        visited.insert(visited.end(), next_.begin(), next_.end());
        return Steered::advanced;
    }
    visited.insert(visited.end(), target.begin(), target.end());
    return Steered::reached;
}

bool StraightSpace::motion_valid(std::span<const double> from, std::span<const double> to) {
    using Verdict = BatchChecker::Verdict;
    if (!batch_ && world_.chain.asv_count() >= 3)
        batch_.emplace(world_.chain, world_.constraints, world_.field);
    const Verdict verdict = batch_ ? batch_->motion(from, to) : Verdict::open;
    if (verdict == Verdict::open) return checker_.valid(from, to);
    ++settled_at_once_;
    return verdict == Verdict::valid;
}

bool StraightSpace::from_unit_cube(std::span<const double> unit, std::span<double> row) {
    const geometry::Box& bounds = world_.constraints.bounds;
    constexpr double pi = std::numbers::pi;
    row[0] = bounds.low.x + unit[0] * (bounds.high.x - bounds.low.x);
    row[1] = bounds.low.y + unit[1] * (bounds.high.y - bounds.low.y);
    if (row.size() > 2) row[2] = (2 * unit[2] - 1) * pi;
    const std::size_t turns = world_.chain.turn_count();
    // The total turn, then from joint to joint the share of what is left: the splits of a whole
    // into n parts are even when the first part is 1 - (1 - u)^(1 / (n - 1)).
    double left = turns == 0 ? 0 : 2 * pi * unit[3];
    for (std::size_t i = 0; i + 1 < turns; ++i) {
        const double rest =
            elementary::pow(1 - unit[4 + i], 1 / static_cast<double>(turns - 1 - i));
        row[3 + i] = left * (1 - rest);
        left *= rest;
    }
    if (turns > 0) row[2 + turns] = left;
    return world_.chain.asv_count() < 3 || shapes_.valid_shape(row);
}

double StraightSpace::extent(std::size_t coordinate) const {
    const geometry::Box& bounds = world_.constraints.bounds;
    if (coordinate == 0) return bounds.high.x - bounds.low.x;
    if (coordinate == 1) return bounds.high.y - bounds.low.y;
    // The heading goes round a full circle. The cube's total turn and shares of it are no single
    // coordinates of the metric; roughly, the total moves the chain as half a circle of the first
    // joint does, and each share as that much over the number of joints.
    const double share = coordinate < 4 ? 1 : 1 / static_cast<double>(world_.chain.turn_count());
    return std::numbers::pi * world_.metric.scale(coordinate) * (coordinate == 2 ? 2 : share);
}

void StraightSpace::perturb(Rng& rng, std::span<const double> row, double sigma,
                            std::span<double> out) const {
    for (std::size_t i = 0; i < row.size(); ++i)
        out[i] = row[i] + sigma / world_.metric.scale(i) * rng.normal();
    for (std::size_t i = 3; i < row.size(); ++i) out[i] = std::abs(out[i]);
}

bool StraightSpace::collides(std::span<const double> row) {
    world_.chain.forward(row, pose_);
    const geometry::Box& bounds = world_.constraints.bounds;
    const std::size_t asvs = pose_.x.size();
    for (std::size_t j = 0; j < asvs; ++j) {
        const geometry::Point at{pose_.x[j], pose_.y[j]};
        if (at.x < bounds.low.x || at.x > bounds.high.x) return true;
        if (at.y < bounds.low.y || at.y > bounds.high.y) return true;
        const std::size_t other = j + 1 < asvs ? j + 1 : j;
        if (world_.field.meets(geometry::Segment{at, {pose_.x[other], pose_.y[other]}}))
            return true;
    }
    return false;
}

double StraightSpace::cost_lower_bound(std::span<const double> from, std::span<const double> to) {
    world_.chain.forward(from, pose_);
    world_.chain.forward(to, other_pose_);
    double sum = 0;
    for (std::size_t j = 0; j < pose_.x.size(); ++j)
        sum += elementary::hypot(pose_.x[j] - other_pose_.x[j], pose_.y[j] - other_pose_.y[j]);
    return sum;
}

const Corridors& StraightSpace::corridors() {
    if (!corridors_)
        corridors_.emplace(world_.constraints.obstacles, world_.constraints.bounds,
                           widest_corridor_);
    return *corridors_;
}

bool StraightSpace::sample_stepwise(Rng& rng, std::span<double> row) {
    return stepwise_.sample(rng, StepwiseSampler::From::first_asv, std::nullopt, true, row);
}

bool StraightSpace::sample_corridor(Rng& rng, std::span<double> row) {
    const auto from =
        rng.chance(0.5) ? StepwiseSampler::From::first_asv : StepwiseSampler::From::last_asv;
    return stepwise_.sample(rng, from, corridors().sample(rng), true, row);
}

}  // namespace asv::core
