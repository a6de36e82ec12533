#include <algorithm>
#include <array>
#include <iostream>
#include <limits>

#include <gtest/gtest.h>

#include "core/validation/motion/motion_collisions.hpp"
#include "geometry/predicates/segment_box.hpp"
#include "tests/core/validation/tolerance.hpp"
#include "tests/kit/chains/paths.hpp"
#include "tests/kit/chains/random_chains.hpp"
#include "tests/kit/chains/reference_tester.hpp"
#include "tests/kit/check_results.hpp"
#include "tests/kit/geometry/random_boxes.hpp"
#include "tests/kit/scaled.hpp"

/// Certificates against dense sampling: never a false "valid", and few false refusals.

namespace asv::core {
namespace {

using test::Points;
using test::Random;
using validation::Moving;

struct RandomMotion {
    Points from;
    Points to;
    std::vector<Box> boxes;
};

/// Steps as planners write them, many of them near a limit: a chain bends, turns and moves; small
/// boxes lie around it.
RandomMotion random_motion(Random& random) {
    const std::size_t n = 3 + random.below(6);
    RandomMotion motion;
    motion.from = test::random_chain(random, n);
    motion.to = motion.from;
    test::shake(random, motion.to, random.one_in(2) ? 1e-5 : 7e-4);
    const double angle = random.uniform(-0.02, 0.02);
    const Point middle = motion.from[n / 2];
    for (Point& point : motion.to) {
        const Point d{point.x - middle.x, point.y - middle.y};
        point = {middle.x + d.x * std::cos(angle) - d.y * std::sin(angle),
                 middle.y + d.x * std::sin(angle) + d.y * std::cos(angle)};
    }
    // Boxes that lie within a few steps of a broom, so that touching is common.
    for (int i = 0; i < 6; ++i) {
        const std::size_t broom = random.below(n - 1);
        const double t = random.uniform(-0.1, 1.1);
        const Point& a = motion.from[broom];
        const Point& b = motion.from[broom + 1];
        const Point low{a.x + t * (b.x - a.x) + random.uniform(-0.004, 0.004),
                        a.y + t * (b.y - a.y) + random.uniform(-0.004, 0.004)};
        motion.boxes.push_back(
            {low, {low.x + random.uniform(0, 0.002), low.y + random.uniform(0, 0.002)}});
    }
    return motion;
}

Points between(const RandomMotion& motion, double t) {
    Points chain;
    for (std::size_t i = 0; i < motion.from.size(); ++i) {
        chain.push_back(Moving{motion.from[i], motion.to[i]}.at(t));
    }
    return chain;
}

/// Which of the five checks fail at some sampled time; counted from Check::broom_lengths.
std::array<bool, 5> sampled_failures(const RandomMotion& motion, int samples, double tolerance) {
    std::array<bool, 5> failures{};
    for (int i = 0; i <= samples; ++i) {
        const Points chain = between(motion, static_cast<double>(i) / samples);
        for (const Check check : test::reference_failures(chain, motion.boxes, tolerance)) {
            failures[static_cast<std::size_t>(check) -
                     static_cast<std::size_t>(Check::broom_lengths)] = true;
        }
    }
    return failures;
}

TEST(MotionSampling, WhatIsCertifiedHoldsAtEverySample) {
    constexpr double rounding = 1e-11;  // of the sampled positions, not of the certificate
    constexpr int samples = 200;
    Random random(4);
    std::array<int, 5> certified{};
    std::array<int, 5> refused{};
    std::array<int, 5> falsely_refused{};
    for (std::size_t i = 0; i < test::scaled(4000); ++i) {
        SCOPED_TRACE("seed 4, motion " + std::to_string(i));
        const RandomMotion motion = random_motion(random);
        Problem problem;
        problem.start = motion.from;
        problem.goal = motion.to;
        problem.obstacles = motion.boxes;
        const ValidationReport report =
            validate(problem, {test::path_of({motion.from, motion.to}), 0}, {.continuous = true});
        const auto fails = sampled_failures(motion, samples, e + rounding);
        const auto nearly_fails = sampled_failures(motion, samples, e - 1e-9);
        for (std::size_t k = 0; k < 5; ++k) {
            const CheckResult& result = report.motion[k];
            ASSERT_FALSE(result.ok() && fails[k]) << name(result.check);
            ++(result.ok() ? certified : refused)[k];
            // Without an area the turns have no side to keep to: that is refused twice.
            const bool has_area = test::find(report.motion, Check::area).ok();
            if (!result.ok() && has_area && !nearly_fails[k]) ++falsely_refused[k];
        }
    }
    for (std::size_t k = 0; k < 5; ++k) {
        const auto check = static_cast<Check>(k + static_cast<std::size_t>(Check::broom_lengths));
        EXPECT_GT(certified[k], 0) << name(check);
        EXPECT_GT(refused[k], 0) << name(check);
        // What lies between two samples may escape them.
        EXPECT_LE(falsely_refused[k], (certified[k] + refused[k]) / 1000) << name(check);
        std::cout << name(check) << ": " << certified[k] << " certified, " << refused[k]
                  << " refused, of these " << falsely_refused[k] << " without a failing sample\n";
    }
}

/// What is roomier than a step before need not be measured.
TEST(MotionSampling, TheTightestOfManyStepsIsThatOfEachOnItsOwn) {
    Random random(7);
    for (std::size_t i = 0; i < test::scaled(200); ++i) {
        SCOPED_TRACE("seed 7, path " + std::to_string(i));
        const RandomMotion first = random_motion(random);
        std::vector<Points> states{first.from, first.to};
        for (int step = 0; step < 20; ++step) {
            states.push_back(states.back());
            test::shake(random, states.back(), 2e-5);
        }
        const auto motion_of = [&](const std::vector<Points>& path) {
            test::Case of_path = test::case_of(path);
            of_path.problem.obstacles = first.boxes;
            return validate(of_path.problem, of_path.solution, {.continuous = true}).motion;
        };
        const std::vector<CheckResult> together = motion_of(states);
        std::vector<double> rooms(together.size(), std::numeric_limits<double>::infinity());
        for (std::size_t step = 1; step < states.size(); ++step) {
            const std::vector<CheckResult> alone = motion_of({states[step - 1], states[step]});
            for (std::size_t k = 0; k < alone.size(); ++k)
                if (alone[k].worst && alone[k].ok() == together[k].ok())
                    rooms[k] = std::min(rooms[k], alone[k].worst->room);
        }
        for (std::size_t k = 0; k < together.size(); ++k)
            if (together[k].worst) {
                ASSERT_EQ(together[k].worst->room, rooms[k]);
            }
    }
}

TEST(MotionSampling, ABroomIsOnlyClearOfABoxThatNoSampleMeets) {
    Random random(5);
    std::size_t clear = 0, contact = 0;
    for (std::size_t i = 0; i < test::scaled(20'000); ++i) {
        SCOPED_TRACE("seed 5, motion " + std::to_string(i));
        // Far larger motions than any step, so that axes of separation change on the way.
        const auto point = [&] { return Point{random.uniform(-1, 1), random.uniform(-1, 1)}; };
        const validation::MovingBroom broom{{point(), point()}, {point(), point()}};
        const Point low = point();
        const Box box{low, {low.x + random.uniform(0, 0.3), low.y + random.uniform(0, 0.3)}};
        const std::optional<double> time = validation::first_contact(broom, box);
        int first = 0;
        while (first <= 300 &&
               !geometry::meets({broom.a.at(first / 300.0), broom.b.at(first / 300.0)}, box)) {
            ++first;
        }
        if (first <= 300) {
            ASSERT_TRUE(time);
            ASSERT_LE(*time, first / 300.0 + 1e-9);
            ++contact;
        }
        if (time) {
            // What was refused does come close: at the time given the two all but touch.
            const geometry::Segment there{broom.a.at(*time), broom.b.at(*time)};
            ASSERT_LT(validation::clearance(there, box).offender.room, 1e-7);
        } else {
            ++clear;
        }
    }
    EXPECT_GT(clear, test::scaled(1000));
    EXPECT_GT(contact, test::scaled(1000));
}

}  // namespace
}  // namespace asv::core
