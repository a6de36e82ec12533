#include "asv/core/space/sliding_space.hpp"

#include "asv/core/space/sampling/passage_points.hpp"

namespace asv::core {

SlidingSpace::SlidingSpace(const BroomWorld& world, const SlideOptions& options)
    : world_(world),
      checker_(world.make_checker()),
      steering_(checker_, world.metric, options),
      sampler_(checker_),
      pose_(world.chain.make_pose()) {}

WrappingAngles SlidingSpace::wrapping() const {
    return {2, world_.chain.asv_count() < 2 ? 0U : 1U};
}

Steered SlidingSpace::steer(std::span<const double> from, std::span<const double> target,
                            Rows& visited) {
    return steering_.slide(from, target, visited);
}

std::optional<geometry::Point> SlidingSpace::pull_target(Rng& rng, double passage_share) const {
    const geometry::Box& bounds = world_.constraints.bounds;
    std::optional<geometry::Point> point;
    if (rng.chance(passage_share)) point = passage_point(world_.field, bounds, rng);
    return point ? point : free_point(world_.field, bounds, rng);
}

geometry::Point SlidingSpace::position(std::span<const double> row, std::size_t asv) {
    world_.chain.forward(row, pose_);
    return {pose_.x[asv], pose_.y[asv]};
}

Steered SlidingSpace::pull(std::span<const double> from, std::size_t asv,
                           const geometry::Point& target, Rows& visited) {
    return steering_.pull(from, asv, target, visited);
}

}  // namespace asv::core
