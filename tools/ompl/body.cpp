#include "tools/ompl/body.hpp"

#include <algorithm>
#include <mutex>
#include <numbers>

#include "core/chain/arm_kinematics.hpp"
#include "core/search/configuration_space.hpp"
#include "core/search/trees/interpolate.hpp"
#include "core/solve/primitive_steps.hpp"
#include "core/space/chain_world.hpp"
#include "core/space/joint_space.hpp"
#include "core/space/joint_world.hpp"
#include "core/space/straight_space.hpp"

namespace asv::adaptor {

namespace {

using core::ChainWorld;
using core::Configurations;
using core::JointWorld;

constexpr double pi = std::numbers::pi;

/// Draws of a whole configuration before one that no shape allows is taken all the same.
constexpr int max_draws = 1000;

// What differs between a chain of ASVs, and an arm or a point.

std::vector<Range> ranges_of(const ChainWorld& world) {
    const core::Box& bounds = world.constraints.bounds;
    std::vector<Range> ranges{{bounds.low.x, bounds.high.x}, {bounds.low.y, bounds.high.y}};
    if (world.chain.dimension() > ranges.size()) ranges.push_back({-pi, pi});
    for (std::size_t i = 0; i < world.chain.turn_count(); ++i)
        ranges.push_back(
            {std::min(0.0, world.constraints.min_turn[i]), world.constraints.max_turn});
    return ranges;
}

std::vector<Range> ranges_of(const JointWorld& world) {
    std::vector<Range> ranges;
    for (const core::JointCoordinate& c : world.coordinates) ranges.push_back({c.low, c.high});
    return ranges;
}

Configurations chain_rows(const ChainWorld&, const Configurations& rows) {
    return rows;
}
Configurations chain_rows(const JointWorld& world, const Configurations& rows) {
    return world.chain_rows(rows);
}

/// Puts the body of the problem at the rows.
void place(const ChainWorld& world, Row start, Row goal, core::Problem& problem) {
    core::Pose pose = world.chain.make_pose();
    world.chain.forward(start, pose);
    core::copy_positions(pose, problem.start);
    world.chain.forward(goal, pose);
    core::copy_positions(pose, problem.goal);
}
void place(const JointWorld& world, Row start, Row goal, core::Problem& problem) {
    auto* arm = std::get_if<core::PlanarArm>(&problem.body);
    if (!arm) {
        problem.start[0] = {start[0], start[1]};
        problem.goal[0] = {goal[0], goal[1]};
        return;
    }
    for (std::size_t i = 0; i < world.coordinates.size(); ++i) {
        arm->start[world.coordinates[i].joint] = start[i];
        arm->goal[world.coordinates[i].joint] = goal[i];
    }
    const core::Point base = problem.start[0];
    problem.start = core::arm_points(*arm, base, arm->start);
    problem.goal = core::arm_points(*arm, base, arm->goal);
}

/// One of the library's spaces. It has scratch memory, so that one thread uses it at a time.
template <class World, core::SampledSpace Space>
class BodyIn : public Body {
  public:
    template <class... Arguments>
    explicit BodyIn(const Arguments&... arguments)
        : world_(arguments...), space_(world_), ranges_(ranges_of(world_)) {}

    const core::Problem& problem() const override { return world_.problem; }
    Row start() const override { return world_.start; }
    Row goal() const override { return world_.goal; }
    const std::vector<Range>& ranges() const override { return ranges_; }
    core::WrappingAngles wrapping() const override { return space_.wrapping(); }

    double extent(std::size_t coordinate) const override {
        const double side = space_.extent(coordinate);
        return wrapping().contains(coordinate) ? side / 2 : side;
    }

    double distance(Row a, Row b) const override { return core::distance_between(space_, a, b); }

    void sample(core::Rng& rng, std::span<double> row) const override {
        const std::scoped_lock lock(mutex_);
        if (space_.sample(rng, row)) return;
        std::vector<double> cube(row.size());
        for (int draw = 0; draw < max_draws; ++draw) {
            for (double& coordinate : cube) coordinate = rng.uniform();
            if (space_.from_unit_cube(cube, row)) return;
        }
    }

    void perturb(core::Rng& rng, Row row, double sigma, std::span<double> out) const override {
        const std::scoped_lock lock(mutex_);
        space_.perturb(rng, row, sigma, out);
    }

    bool valid(Row row) const override {
        const std::scoped_lock lock(mutex_);
        return space_.valid(row);
    }

    bool motion_valid(Row from, Row to) const override {
        const std::vector<double> end = unwrapped(to, from, wrapping());
        const std::scoped_lock lock(mutex_);
        return space_.motion_valid(from, end);
    }

    std::vector<double> proven_end(Row from, Row to) const override {
        const std::vector<double> end = unwrapped(to, from, wrapping());
        Configurations visited(from.begin(), from.end());
        const std::scoped_lock lock(mutex_);
        space_.steer(from, end, visited);
        return {visited.end() - static_cast<std::ptrdiff_t>(from.size()), visited.end()};
    }

    double cost(Row from, Row to) const override {
        const std::vector<double> end = unwrapped(to, from, wrapping());
        const std::scoped_lock lock(mutex_);
        return space_.cost(from, end);
    }

    double cost_lower_bound(Row from, Row to) const override {
        const std::vector<double> end = unwrapped(to, from, wrapping());
        const std::scoped_lock lock(mutex_);
        return space_.cost_lower_bound(from, end);
    }

    std::optional<core::Path> steps(const Configurations& rows,
                                    core::Clock::time_point deadline) const override {
        core::MotionChecker checker = world_.make_checker();
        return core::primitive_steps_before(deadline, world_.problem, chain_rows(world_, rows),
                                            checker);
    }

    core::Problem problem_between(Row start, Row goal) const override {
        core::Problem problem = world_.problem;
        place(world_, start, goal, problem);
        return problem;
    }

  private:
    World world_;
    mutable std::mutex mutex_;  ///< of what the space does with its scratch memory
    mutable Space space_;
    std::vector<Range> ranges_;
};

}  // namespace

std::shared_ptr<const Body> make_body(const core::Problem& problem) {
    if (problem.body_kind() == core::BodyKind::chain)
        return std::make_shared<BodyIn<ChainWorld, core::StraightSpace>>(problem,
                                                                         core::Anchor::centroid);
    return std::make_shared<BodyIn<JointWorld, core::JointSpace>>(problem);
}

std::vector<double> unwrapped(Row row, Row other, core::WrappingAngles angles) {
    std::vector<double> result(row.begin(), row.end());
    core::unwrap(result, other, angles);
    return result;
}

}  // namespace asv::adaptor
