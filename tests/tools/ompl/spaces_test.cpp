#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/solve/solve.hpp"
#include "core/validation/validate.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/tools/ompl/ompl_samples.hpp"
#include "tools/ompl/body_checks.hpp"
#include "tools/ompl/body_space.hpp"
#include "tools/ompl/ompl_problem.hpp"

/// The space of a body as OMPL sees it.

namespace asv::test {
namespace {

using adaptor::BodySpace;
using adaptor::MotionCheck;
using adaptor::OmplProblem;
namespace ob = ompl::base;

const std::vector<std::string> one_of_each_body{
    "3ASV.txt", "7ASV.txt", "bodies/arm-4-workshop.json", "bodies/point-town.json"};

/// OMPL's own tests of a space: symmetry, triangles, interpolation, bounds, copies.
TEST(OmplSpace, PassesTheChecksOfOmpl) {
    for (const std::string& name : one_of_each_body) {
        const OmplProblem adapted(testcase(name));
        EXPECT_NO_THROW(adapted.space_information()->getStateSpace()->sanityChecks()) << name;
    }
}

TEST(OmplSpace, StatesAreConfigurationsAndTheMetricIsThatOfTheLibrary) {
    for (const std::string& name : one_of_each_body) {
        const OmplProblem adapted(testcase(name));
        const BodySpace& space = adaptor::body_space_of(*adapted.space_information());
        const auto sampler = space.allocStateSampler();
        ob::ScopedState<> a(adapted.space_information()), b(a), middle(a);
        for (int i = 0; i < 50; ++i) {
            sampler->sampleUniform(a.get());
            sampler->sampleUniformNear(b.get(), a.get(), 0.3);
            EXPECT_TRUE(space.satisfiesBounds(a.get())) << name;
            EXPECT_LE(space.distance(a.get(), b.get()), 0.3 + 1e-9) << name;
            EXPECT_DOUBLE_EQ(space.distance(a.get(), b.get()),
                             space.body().distance(space.row(a.get()), space.row(b.get())));
            // A configuration is the same one a full turn later.
            std::vector<double> turned(space.row(a.get()).begin(), space.row(a.get()).end());
            if (const auto angles = space.body().wrapping(); angles.count > 0)
                turned[angles.first] += 2 * std::numbers::pi;
            space.assign(turned, middle.get());
            EXPECT_NEAR(space.distance(a.get(), middle.get()), 0, 1e-12) << name;
            space.interpolate(a.get(), b.get(), 0.5, middle.get());
            EXPECT_NEAR(space.distance(a.get(), middle.get()), space.distance(a.get(), b.get()) / 2,
                        1e-9);
        }
    }
}

TEST(OmplSpace, StartAndGoalComeBackAsTheyWereGiven) {
    for (const std::string& name : one_of_each_body) {
        const core::Problem given = testcase(name);
        const OmplProblem adapted(given);
        const BodySpace& space = adaptor::body_space_of(*adapted.space_information());
        const core::Problem back = space.body().problem_between(space.row(adapted.start().get()),
                                                                space.row(adapted.goal().get()));
        for (std::size_t j = 0; j < given.asv_count(); ++j) {
            const core::Problem& planned = space.body().problem();
            EXPECT_NEAR(back.start[j].x, planned.start[j].x, 1e-9) << name;
            EXPECT_NEAR(back.goal[j].y, planned.goal[j].y, 1e-9) << name;
        }
        EXPECT_TRUE(adapted.space_information()->isValid(adapted.start().get())) << name;
        EXPECT_TRUE(adapted.space_information()->isValid(adapted.goal().get())) << name;
    }
}

TEST(OmplMotions, TheProofSeesWhatSamplesMiss) {
    const core::Problem problem = before_a_thin_wall();
    const OmplProblem certified(problem), sampled(problem, MotionCheck::sampled);
    const auto start = sampled.start(), goal = sampled.goal();
    EXPECT_TRUE(sampled.space_information()->checkMotion(start.get(), goal.get()));
    const ob::ScopedState<> from = certified.start(), to = certified.goal();
    EXPECT_FALSE(certified.space_information()->checkMotion(from.get(), to.get()));

    ompl::geometric::PathGeometric path(sampled.space_information(), start.get(), goal.get());
    EXPECT_FALSE(sampled.certified(path));
    EXPECT_FALSE(core::validate(problem, sampled.solution(path).value()).valid());
}

/// The part of a motion that is proven ends before the wall, and is a valid motion.
TEST(OmplMotions, TheLastValidStateIsBeforeWhatIsInTheWay) {
    const OmplProblem adapted(before_a_thin_wall());
    const ob::ScopedState<> from = adapted.start(), to = adapted.goal();
    ob::ScopedState<> last(adapted.space_information());
    std::pair<ob::State*, double> last_valid(last.get(), 0.0);
    EXPECT_FALSE(adapted.space_information()->checkMotion(from.get(), to.get(), last_valid));
    EXPECT_GT(last_valid.second, 0.4);
    EXPECT_LT(last_valid.second, 0.5);
    EXPECT_NEAR(last[0], 0.1 + 0.8 * last_valid.second, 1e-9);
    EXPECT_TRUE(adapted.space_information()->checkMotion(from.get(), last.get()));
}

TEST(OmplProblem, WhatHasNoPathIsAnError) {
    core::Problem blocked = past_a_box();
    blocked.obstacles[0] = {{0.1, 0.4}, {0.2, 0.6}};
    EXPECT_THROW(OmplProblem{blocked}, core::InvalidEnds);
    core::Problem mirrored = past_a_box();
    std::swap(mirrored.goal[0], mirrored.goal[2]);
    EXPECT_THROW(OmplProblem{mirrored}, std::invalid_argument);
}

TEST(OmplProblem, AnotherSpaceIsAnError) {
    const auto plane = std::make_shared<ob::RealVectorStateSpace>(2U);
    const auto information = std::make_shared<ob::SpaceInformation>(plane);
    EXPECT_THROW(adaptor::body_space_of(*information), std::invalid_argument);
}

}  // namespace
}  // namespace asv::test
