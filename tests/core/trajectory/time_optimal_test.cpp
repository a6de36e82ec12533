#include "core/trajectory/time_optimal.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "core/validation/trajectory/validate_trajectory.hpp"
#include "tests/core/trajectory/sample_paths.hpp"
#include "tests/kit/random.hpp"
#include "tests/kit/scaled.hpp"

/// Of every trajectory here, velocities and accelerations are computed anew from its samples.

namespace asv::test {
namespace {

using core::MotionLimits;
using core::Path;
using core::time_optimal;
using core::Trajectory;

/// By which share of a limit it is exceeded at most; negative where room is left.
double excess(const Trajectory& trajectory, const MotionLimits& limits) {
    double most = -1;
    for (std::size_t i = 0; i < trajectory.states.asv_count(); ++i) {
        Point velocity;
        double time = 0;
        for (std::size_t k = 1; k <= trajectory.size(); ++k) {
            Point next;
            double next_time = 0;
            if (k < trajectory.size()) {
                const Point a = trajectory.states.state(k - 1)[i];
                const Point b = trajectory.states.state(k)[i];
                next_time = trajectory.times[k] - trajectory.times[k - 1];
                EXPECT_GT(next_time, 0) << "sample " << k;
                next = {(b.x - a.x) / next_time, (b.y - a.y) / next_time};
            }
            const double speed = std::hypot(next.x, next.y);
            const double acceleration =
                std::hypot(next.x - velocity.x, next.y - velocity.y) * 2 / (time + next_time);
            most = std::max({most, speed / limits.speed_of(i) - 1,
                             acceleration / limits.acceleration_of(i) - 1});
            velocity = next;
            time = next_time;
        }
    }
    return most;
}

/// The trajectory, which keeps all limits and begins and ends as the path does.
Trajectory checked(const Path& path, const MotionLimits& limits) {
    Trajectory trajectory = time_optimal(path, limits);
    EXPECT_EQ(trajectory.states.size(), trajectory.times.size());
    EXPECT_EQ(trajectory.times.front(), 0);
    if (trajectory.size() > 1) {
        // The rounding of this computation, beside that of the one that is tested.
        EXPECT_LE(excess(trajectory, limits), 1e-12);
        EXPECT_TRUE(std::ranges::equal(trajectory.states.state(trajectory.size() - 1),
                                       path.state(path.size() - 1)));
    }
    EXPECT_TRUE(std::ranges::equal(trajectory.states.state(0), path.state(0)));
    return trajectory;
}

TEST(TimeOptimal, ALongStraightRunTakesHardlyLongerThanAtFullSpeed) {
    const MotionLimits limits{{0.1}, {2}};
    const double duration = checked(straight_run(7, 1000, 0.001), limits).duration();
    const double bound = 1 / 0.1;
    EXPECT_GE(duration, bound);
    EXPECT_LE(duration, 1.01 * bound);
}

TEST(TimeOptimal, SpeedsUpAndBrakesEvenly) {
    // From rest to full speed and back takes speed / acceleration longer than full speed alone.
    EXPECT_NEAR(checked(straight_run(2, 4000, 0.001), {{0.5}, {0.25}}).duration(),
                4 / 0.5 + 0.5 / 0.25, 1e-2);
    // Where full speed is out of reach, half of the way is speeding up.
    EXPECT_NEAR(checked(straight_run(2, 4000, 0.001), {{100}, {0.25}}).duration(),
                2 * std::sqrt(4 / 0.25), 1e-2);
}

TEST(TimeOptimal, TheSlowestVehicleSetsThePace) {
    const Path path = straight_run(3, 1000, 0.001);
    const MotionLimits one_slow{{0.5, 0.05, 0.5}, {2}}, one_lazy{{0.5}, {2, 2, 0.02}};
    EXPECT_NEAR(checked(path, one_slow).duration(), checked(path, {{0.05}, {2}}).duration(), 1e-9);
    EXPECT_NEAR(checked(path, one_lazy).duration(), checked(path, {{0.5}, {0.02}}).duration(),
                1e-9);
    // One that does not move may be as slow as it likes.
    EXPECT_NEAR(checked(beside_a_resting_one(path), {{0.5, 0.5, 0.5, 1e-9}, {2}}).duration(),
                checked(path, {{0.5}, {2}}).duration(), 1e-9);
}

TEST(TimeOptimal, ACircleIsPassedAsFastAsItsCurvatureAllows) {
    const double radius = 0.5, acceleration = 0.08;
    const Trajectory round = checked(circle(radius, 3000), {{10}, {acceleration}});
    const double steady = 2 * std::numbers::pi * radius / std::sqrt(acceleration * radius);
    EXPECT_GT(round.duration(), steady);
    // It takes a while to reach that speed, and to brake.
    EXPECT_LT(round.duration(), steady + 2 * std::sqrt(acceleration * radius) / acceleration);
    const double fastest = core::vehicle_motions(round)[round.size() / 2].speed;
    EXPECT_NEAR(fastest, std::sqrt(acceleration * radius), 1e-3);
}

TEST(TimeOptimal, SlowsDownAtACorner) {
    const MotionLimits limits{{1}, {0.5}};
    const Trajectory turned = checked(around_a_corner(500, 0.001), limits);
    const auto motions = core::vehicle_motions(turned);
    EXPECT_LT(motions[500].speed, 0.1 * motions[250].speed);
    // As if it stopped there, or a little faster.
    const double with_a_stop = 2 * 2 * std::sqrt(0.5 / 0.5);
    EXPECT_NEAR(turned.duration(), with_a_stop, 0.05 * with_a_stop);
}

TEST(TimeOptimal, IsAsFastBackwards) {
    Random random(1);
    for (std::size_t i = 0; i < scaled(50); ++i) {
        const Path path = winding_path(random, 1 + random.below(5), 200);
        const MotionLimits limits{{random.uniform(0.01, 1)}, {random.uniform(0.01, 1)}};
        const double there = checked(path, limits).duration();
        EXPECT_NEAR(checked(reversed(path), limits).duration(), there, 1e-6 * there) << i;
    }
}

TEST(TimeOptimal, KeepsTheLimitsOfEachVehicleOnWildPaths) {
    Random random(2);
    for (std::size_t i = 0; i < scaled(200); ++i) {
        const std::size_t n = 1 + random.below(6);
        MotionLimits limits;
        for (std::size_t vehicle = 0; vehicle < n; ++vehicle) {
            limits.speed.push_back(std::pow(10, random.uniform(-3, 3)));
            limits.acceleration.push_back(std::pow(10, random.uniform(-3, 3)));
        }
        const Path path = wild_path(random, n, 1 + random.below(60));
        const Trajectory trajectory = checked(path, limits);
        EXPECT_TRUE(core::validate_trajectory(core::BodyKind::chain, path, trajectory, limits,
                                              {.tolerance = 2e-6})
                        .valid())
            << i;
    }
}

TEST(TimeOptimal, ScalesWithTheLimits) {
    // With speeds s times as great and accelerations s^2 times, all takes 1/s of the time.
    Random random(3);
    const Path path = winding_path(random, 4, 300);
    const double duration = checked(path, {{0.2}, {0.1}}).duration();
    EXPECT_NEAR(checked(path, {{0.6}, {0.9}}).duration(), duration / 3, 1e-6 * duration);
}

TEST(TimeOptimal, GreaterLimitsAreNeverSlower) {
    Random random(4);
    for (std::size_t i = 0; i < scaled(50); ++i) {
        const Path path = winding_path(random, 1 + random.below(5), 200);
        const MotionLimits limits{{random.uniform(0.01, 1)}, {random.uniform(0.01, 1)}};
        const MotionLimits faster{{2 * limits.speed[0]}, limits.acceleration};
        const MotionLimits stronger{limits.speed, {2 * limits.acceleration[0]}};
        const double duration = checked(path, limits).duration() * (1 + 1e-6);
        EXPECT_LE(checked(path, faster).duration(), duration) << i;
        EXPECT_LE(checked(path, stronger).duration(), duration) << i;
    }
}

TEST(TimeOptimal, LeavesOutStatesThatRepeat) {
    const Path path = straight_run(2, 100, 0.001);
    Path slow(2);
    for (std::size_t k = 0; k < path.size(); ++k)
        for (std::size_t again = 0; again <= k % 3; ++again) slow.push_back(path.state(k));
    const Trajectory expected = checked(path, {{1}, {1}}), found = checked(slow, {{1}, {1}});
    EXPECT_EQ(found.states, expected.states);
    EXPECT_EQ(found.times, expected.times);
}

TEST(TimeOptimal, EndsAtTheLastStateThoughItNearlyRepeatsTheOneBefore) {
    Path path = straight_run(1, 10, 0.001);
    path.push_back(Points{{0.01 + 1e-12, 0}});
    const Trajectory trajectory = checked(path, {{1}, {1}});
    EXPECT_EQ(trajectory.size(), 11U);
}

TEST(TimeOptimal, GoesToAndFro) {
    Path path = straight_run(1, 200, 0.001);
    const Path back = reversed(path);
    for (std::size_t k = 1; k < back.size(); ++k) path.push_back(back.state(k));
    // It stops in the middle, or nearly so.
    const double there = checked(back, {{1}, {0.1}}).duration();
    EXPECT_NEAR(checked(path, {{1}, {0.1}}).duration(), 2 * there, 0.05 * there);
}

TEST(TimeOptimal, APathThatStaysHasASingleSample) {
    Path path(2);
    for (int i = 0; i < 3; ++i) {
        path.push_back(Points{{0.1, 0.2}, {0.3, 0.4}});
        const Trajectory trajectory = checked(path, {{1}, {1}});
        EXPECT_EQ(trajectory.size(), 1U);
        EXPECT_EQ(trajectory.duration(), 0);
    }
}

TEST(TimeOptimal, ASingleStepSpeedsUpAndBrakesAtItsEnds) {
    // Half of its time is the time to change the velocity: d / t = a t / 2.
    EXPECT_NEAR(checked(straight_run(1, 1, 0.08), {{9}, {1}}).duration(), 0.4, 1e-6);
    EXPECT_NEAR(checked(straight_run(1, 1, 0.08), {{0.1}, {1}}).duration(), 0.8, 1e-6);
}

TEST(TimeOptimal, StandsNumbersOfAnySize) {
    const double least = core::least_motion_limit, greatest = core::greatest_motion_limit;
    for (const double step : {1e-60, 1e-3, 1e60})
        for (const double speed : {least, greatest})
            for (const double acceleration : {least, greatest})
                EXPECT_EQ(checked(straight_run(2, 50, step), {{speed}, {acceleration}}).size(), 51U)
                    << step << ' ' << speed << ' ' << acceleration;
}

TEST(TimeOptimal, RefusesWhatMakesNoSense) {
    const Path path = straight_run(3, 5, 0.001);
    EXPECT_THROW(time_optimal(Path(3), {{1}, {1}}), std::invalid_argument);
    EXPECT_THROW(time_optimal(path, {{1, 1}, {1}}), std::invalid_argument);
    EXPECT_THROW(time_optimal(path, {{1}, {}}), std::invalid_argument);
    for (const double bad : {0.0, -1.0, 1e13, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_THROW(time_optimal(path, {{1, bad, 1}, {1}}), std::invalid_argument) << bad;
        EXPECT_THROW(time_optimal(path, {{1}, {bad}}), std::invalid_argument) << bad;
    }
}

}  // namespace
}  // namespace asv::test
