#include "core/validation/trajectory/validate_trajectory.hpp"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/kit/chains/paths.hpp"
#include "tests/kit/check_results.hpp"

namespace asv::test {
namespace {

using core::Check;
using core::MotionLimits;
using core::Path;
using core::Trajectory;
using Checks = std::vector<Check>;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// One vehicle on the x axis, beside one that rests.
Path along_x(const std::vector<double>& places) {
    std::vector<Points> states;
    for (const double x : places) states.push_back({{x, 0}, {0, 1}});
    return path_of(states);
}

core::ValidationReport judge(const Path& path, const Trajectory& trajectory,
                             const MotionLimits& limits, bool list = false) {
    return core::validate_trajectory(core::BodyKind::chain, path, trajectory, limits,
                                     {.list_offenders = list});
}

/// With limits that nothing exceeds.
Checks failures(const Path& path, const Trajectory& trajectory) {
    return failed(judge(path, trajectory, {{1e9}, {1e9}}).checks);
}

/// Speeds 1, 2, 1; the velocity changes by 1 within 1, 0.75, 0.75 and 1 seconds: half of the first
/// and the last interval, and half of two others.
const Path four = along_x({0, 2, 4, 6});
const Trajectory passed{four, {0, 2, 3, 5}};

TEST(ValidateTrajectory, SaysWhatItChecksInOrder) {
    const auto report = judge(four, passed, {{3}, {3}});
    ASSERT_EQ(report.checks.size(), 4U);
    const Checks expected{Check::times, Check::same_path, Check::speed, Check::acceleration};
    const std::size_t counts[] = {3, 4, 3, 4};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(report.checks[i].check, expected[i]);
        EXPECT_EQ(report.checks[i].states, counts[i]);
        EXPECT_TRUE(report.checks[i].ok());
    }
    EXPECT_TRUE(report.motion.empty());
}

TEST(ValidateTrajectory, SpeedIsTheDistanceByTheTime) {
    EXPECT_TRUE(judge(four, passed, {{2}, {9}}).valid());
    const auto report = judge(four, passed, {{1.75, 9}, {9}});
    EXPECT_EQ(failed(report.checks), Checks{Check::speed});
    const auto& speed = find(report.checks, Check::speed);
    EXPECT_EQ(speed.failures, 1U);
    EXPECT_EQ(speed.worst->state, 2U);
    EXPECT_EQ(speed.worst->asv, 0U);
    EXPECT_DOUBLE_EQ(speed.worst->room, -0.25);
    EXPECT_TRUE(judge(four, passed, {{9, 1e-9}, {9}}).valid()) << "the other one rests";
}

TEST(ValidateTrajectory, AccelerationIsTheChangeByTheMeanOfTheTimes) {
    EXPECT_TRUE(judge(four, passed, {{9}, {1}}).valid());
    const auto report = judge(four, passed, {{9}, {0.5, 9}}, true);
    EXPECT_EQ(failed(report.checks), Checks{Check::acceleration});
    const auto& acceleration = find(report.checks, Check::acceleration);
    ASSERT_EQ(acceleration.offenders.size(), 4U);
    for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(acceleration.offenders[k].state, k);
        // At the ends from rest to 1 within 1 s, between them from 1 to 2 within 1.5 s.
        const double expected = k == 0 || k == 3 ? 1.0 : 2.0 / 3;
        EXPECT_NEAR(acceleration.offenders[k].room, 0.5 - expected, 1e-12) << k;
    }
}

TEST(ValidateTrajectory, AMillionthIsRounding) {
    EXPECT_TRUE(judge(four, passed, {{2 * (1 - 9e-7)}, {9}}).valid());
    EXPECT_FALSE(judge(four, passed, {{2 * (1 - 2e-6)}, {9}}).valid());
    EXPECT_TRUE(judge(four, passed, {{9}, {1 - 9e-7}}).valid());
    EXPECT_FALSE(judge(four, passed, {{9}, {1 - 2e-6}}).valid());
}

TEST(ValidateTrajectory, TimesHaveToIncrease) {
    for (const double third : {2.0, 1.0}) {
        const auto report = judge(four, {four, {0, 2, third, 5}}, {{9}, {9}});
        EXPECT_EQ(failed(report.checks), Checks{Check::times});
        EXPECT_EQ(find(report.checks, Check::times).worst->state, 2U);
        EXPECT_EQ(find(report.checks, Check::speed).states, 0U) << "there is none to speak of";
    }
    EXPECT_EQ(failures(four, {four, {-5, -4, 0, 1}}), Checks{}) << "they begin anywhere";
}

TEST(ValidateTrajectory, AStateMayRepeat) {
    const Path stays = along_x({0, 0, 2, 2, 2, 4, 6, 6});
    EXPECT_EQ(failures(stays, passed), Checks{});
    EXPECT_EQ(failures(four, {stays, {0, 1, 2, 3, 4, 5, 6, 7}}), Checks{}) << "it waits";
    EXPECT_EQ(failures(along_x({1, 1}), {along_x({1}), {0}}), Checks{});
    EXPECT_EQ(failures(along_x({1}), {along_x({1, 1}), {0, 1}}), Checks{});
}

TEST(ValidateTrajectory, StepsMayBeSmallerThanTheTolerance) {
    std::vector<double> places, fewer;
    for (int i = 0; i < 200; ++i) places.push_back(3e-6 * i * (i < 100 ? 1 : 10));
    Trajectory trajectory{along_x(places), {}};
    for (int i = 0; i < 200; ++i) trajectory.times.push_back(i);
    places.insert(places.begin() + 50, 3, places[50]);
    EXPECT_EQ(failures(along_x(places), trajectory), Checks{});
}

/// Where it leaves the path.
void expect_off(const Path& path, const Path& samples, std::size_t sample) {
    Trajectory trajectory{samples, {}};
    for (std::size_t k = 0; k < samples.size(); ++k)
        trajectory.times.push_back(static_cast<double>(k));
    const auto report = judge(path, trajectory, {{1e9}, {1e9}});
    EXPECT_EQ(failed(report.checks), Checks{Check::same_path});
    const auto& result = find(report.checks, Check::same_path);
    ASSERT_TRUE(result.worst);
    EXPECT_EQ(result.failures, 1U);
    EXPECT_EQ(result.worst->state, sample);
    EXPECT_EQ(result.worst->asv, 0U);
}

TEST(ValidateTrajectory, SamplesAreTheStatesInTheirOrder) {
    expect_off(four, along_x({0.1, 2, 4, 6}), 0);
    expect_off(four, along_x({0, 2, 4.1, 6}), 2);
    expect_off(four, along_x({0, 2, 6}), 2);
    expect_off(four, along_x({0, 4, 2, 6}), 1);
    expect_off(four, along_x({0, 2, 4}), 2);
    expect_off(four, along_x({0, 2, 4, 6, 8}), 4);
    expect_off(four, along_x({0, 2, 4, 6, 4}), 4);
    expect_off(four, along_x({0}), 0);
    expect_off(four, along_x({0, 1, 2, 4, 6}), 1);
}

TEST(ValidateTrajectory, SamplesMayBeOffByTheTolerance) {
    EXPECT_EQ(failures(four, {along_x({0, 2 + 9e-6, 4, 6}), {0, 1, 2, 3}}), Checks{});
    EXPECT_EQ(failures(four, {along_x({0, 2 + 2e-5, 4, 6}), {0, 1, 2, 3}}),
              Checks{Check::same_path});
}

TEST(ValidateTrajectory, WhatIsNotFiniteFails) {
    for (const double bad : {infinity, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_EQ(failures(four, {four, {0, 2, bad, 5}}), Checks{Check::times});
        EXPECT_EQ(failures(four, {along_x({0, 2, bad, 6}), {0, 2, 3, 5}}), Checks{Check::times});
    }
}

TEST(ValidateTrajectory, ASingleSampleHasNoSpeed) {
    const Path one = along_x({1});
    const auto report = judge(one, {one, {0}}, {{1}, {1}});
    EXPECT_TRUE(report.valid());
    EXPECT_EQ(find(report.checks, Check::acceleration).states, 0U);
}

TEST(ValidateTrajectory, RefusesWhatDoesNotBelongTogether) {
    const auto refused = [](const Path& path, const Trajectory& trajectory,
                            const MotionLimits& limits, double tolerance = 0) {
        EXPECT_THROW(core::validate_trajectory(core::BodyKind::chain, path, trajectory, limits,
                                               {.tolerance = tolerance}),
                     std::invalid_argument);
    };
    refused(Path(2), passed, {{1}, {1}});
    refused(four, {Path(2), {}}, {{1}, {1}});
    refused(four, {four, {0, 1, 2}}, {{1}, {1}});
    refused(path_of({{{0, 0}}}), passed, {{1}, {1}});
    refused(four, passed, {{1, 1, 1}, {1}});
    refused(four, passed, {{1}, {}});
    refused(four, passed, {{1}, {1}}, -1);
    refused(four, passed, {{1}, {1}}, infinity);
}

}  // namespace
}  // namespace asv::test
