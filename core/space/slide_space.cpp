#include "core/space/slide_space.hpp"

#include <algorithm>
#include <cmath>

#include "core/bounds/asv_plane.hpp"
#include "core/space/sampling/passage_points.hpp"
#include "geometry/elementary/functions.hpp"

namespace asv::core {

namespace {

/// Cells that the search for a guide may enter, each as often as it is: some milliseconds.
constexpr std::size_t guide_effort = 10'000;
/// Longest way from stop to stop of a guide.
constexpr double stop_spacing = 0.05;
/// Standard deviation of what is drawn near a point.
constexpr double nearby = 0.03;

}  // namespace

SlideSpace::SlideSpace(const ChainWorld& world, const SlideOptions& options)
    : world_(world),
      checker_(world.make_checker()),
      steering_(checker_, world.metric, options),
      sampler_(checker_),
      pose_(world.chain.make_pose()) {}

Steered SlideSpace::steer(std::span<const double> from, std::span<const double> target,
                          Configurations& visited) {
    return steering_.slide(from, target, visited);
}

std::optional<geometry::Point> SlideSpace::pull_target(Rng& rng, double passage_share) const {
    const geometry::Box& bounds = world_.constraints.bounds;
    std::optional<geometry::Point> point;
    if (rng.chance(passage_share)) point = passage_point(world_.field, bounds, rng);
    return point ? point : free_point(world_.field, bounds, rng);
}

std::vector<geometry::Point> SlideSpace::guide() const {
    const Problem& problem = world_.problem;
    const std::size_t middle = problem.asv_count() / 2;
    geometry::FreePlane plane = make_asv_plane(problem, Reading::intended);
    const auto bends =
        plane.shortest_path_points(problem.start[middle], problem.goal[middle], guide_effort);
    std::vector<geometry::Point> stops;
    for (std::size_t i = 1; i < bends.size(); ++i) {
        const geometry::Point &a = bends[i - 1], &b = bends[i];
        const double length = elementary::hypot(b.x - a.x, b.y - a.y);
        // One piece at least: an ASV that ends where it starts has a way without length.
        const double pieces = std::max(1.0, std::ceil(length / stop_spacing));
        for (double piece = i == 1 ? 0 : 1; piece <= pieces; ++piece) {
            const double t = piece / pieces;
            stops.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
        }
    }
    return stops;
}

bool SlideSpace::sample_near(Rng& rng, const geometry::Point& point, std::span<double> row) {
    return sampler_.sample_near(rng, point, nearby, row);
}

geometry::Point SlideSpace::position(std::span<const double> row, std::size_t asv) {
    world_.chain.forward(row, pose_);
    return {pose_.x[asv], pose_.y[asv]};
}

Steered SlideSpace::pull(std::span<const double> from, std::size_t asv,
                         const geometry::Point& target, Configurations& visited) {
    return steering_.pull(from, asv, target, visited);
}

}  // namespace asv::core
