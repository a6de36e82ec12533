#include <array>
#include <iostream>

#include <gtest/gtest.h>

#include "core/validation/motion/motion_collisions.hpp"
#include "core/validation/motion/quadratic.hpp"
#include "geometry/predicates/segment_box.hpp"
#include "tests/kit/random_cases.hpp"
#include "tests/kit/reference_tester.hpp"

/// Certificates against dense sampling: never a false "valid", and few false refusals.

namespace asv::core {
namespace {

using test::Chain;
using test::uniform;
using validation::Moving;

constexpr double e = 1e-5;

struct RandomMotion {
    Chain from;
    Chain to;
    std::vector<Box> boxes;
};

/// Steps as planners write them, many of them near a limit: a chain bends, turns and moves; small
/// boxes lie around it.
RandomMotion random_motion(std::mt19937_64& random) {
    const std::size_t n = 3 + random() % 6;
    RandomMotion motion;
    motion.from = test::random_chain(random, n);
    motion.to = motion.from;
    test::shake(random, motion.to, random() % 2 == 0 ? 1e-5 : 7e-4);
    const double angle = uniform(random, -0.02, 0.02);
    const Point middle = motion.from[n / 2];
    for (Point& point : motion.to) {
        const Point d{point.x - middle.x, point.y - middle.y};
        point = {middle.x + d.x * std::cos(angle) - d.y * std::sin(angle),
                 middle.y + d.x * std::sin(angle) + d.y * std::cos(angle)};
    }
    // Boxes that lie within a few steps of a broom, so that touching is common.
    for (int i = 0; i < 6; ++i) {
        const std::size_t broom = random() % (n - 1);
        const double t = uniform(random, -0.1, 1.1);
        const Point& a = motion.from[broom];
        const Point& b = motion.from[broom + 1];
        const Point low{a.x + t * (b.x - a.x) + uniform(random, -0.004, 0.004),
                        a.y + t * (b.y - a.y) + uniform(random, -0.004, 0.004)};
        motion.boxes.push_back(
            {low, {low.x + uniform(random, 0, 0.002), low.y + uniform(random, 0, 0.002)}});
    }
    return motion;
}

Chain between(const RandomMotion& motion, double t) {
    Chain chain;
    for (std::size_t i = 0; i < motion.from.size(); ++i) {
        chain.push_back(Moving{motion.from[i], motion.to[i]}.at(t));
    }
    return chain;
}

/// Which of the five checks fail at some sampled time; counted from Check::broom_lengths.
std::array<bool, 5> sampled_failures(const RandomMotion& motion, int samples, double tolerance) {
    std::array<bool, 5> failures{};
    for (int i = 0; i <= samples; ++i) {
        const Chain chain = between(motion, static_cast<double>(i) / samples);
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
    std::mt19937_64 random(4);
    std::array<int, 5> certified{};
    std::array<int, 5> refused{};
    std::array<int, 5> falsely_refused{};
    for (int i = 0; i < test::scaled(4000); ++i) {
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

TEST(MotionSampling, ABroomIsOnlyClearOfABoxThatNoSampleMeets) {
    std::mt19937_64 random(5);
    int clear = 0;
    int contact = 0;
    for (int i = 0; i < test::scaled(20'000); ++i) {
        SCOPED_TRACE("seed 5, motion " + std::to_string(i));
        // Far larger motions than any step, so that axes of separation change on the way.
        const auto point = [&] { return Point{uniform(random, -1, 1), uniform(random, -1, 1)}; };
        const validation::MovingBroom broom{{point(), point()}, {point(), point()}};
        const Point low = point();
        const Box box{low, {low.x + uniform(random, 0, 0.3), low.y + uniform(random, 0, 0.3)}};
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

TEST(Quadratic, CoversTheTrueProductsWithItsError) {
    std::mt19937_64 random(6);
    for (int i = 0; i < test::scaled(20'000); ++i) {
        SCOPED_TRACE("seed 6, case " + std::to_string(i));
        const double size = std::pow(10, uniform(random, -9, 3));
        const auto point = [&] {
            return Point{uniform(random, 0.3, 0.7) + uniform(random, -size, size),
                         uniform(random, 0.3, 0.7) + uniform(random, -size, size)};
        };
        const std::array<Moving, 4> p = {Moving{point(), point()}, Moving{point(), point()},
                                         Moving{point(), point()}, Moving{point(), point()}};
        const double t = uniform(random, 0, 1);
        // The exact value but for the rounding of long double, 2000 times finer.
        const auto exact = [&](const Moving& a, const Moving& b) {
            const auto at = [&](double from, double to) {
                return from + (static_cast<long double>(to) - from) * t;
            };
            return std::pair{at(b.from.x, b.to.x) - at(a.from.x, a.to.x),
                             at(b.from.y, b.to.y) - at(a.from.y, a.to.y)};
        };
        const auto [ux, uy] = exact(p[0], p[1]);
        const auto [vx, vy] = exact(p[2], p[3]);
        const Moving u = validation::difference(p[0], p[1]);
        const Moving v = validation::difference(p[2], p[3]);
        const validation::Quadratic cross = validation::cross(u, v);
        const validation::Quadratic dot = validation::dot(u, v);
        ASSERT_LE(std::abs(static_cast<double>(cross.at(t) - (ux * vy - uy * vx))), cross.error);
        ASSERT_LE(std::abs(static_cast<double>(dot.at(t) - (ux * vx + uy * vy))), dot.error);
    }
}

TEST(Quadratic, IsLeastWhereNoSampleIsLess) {
    std::mt19937_64 random(7);
    for (int i = 0; i < test::scaled(5000); ++i) {
        SCOPED_TRACE("seed 7, case " + std::to_string(i));
        const validation::Quadratic q{uniform(random, -1, 1), uniform(random, -1, 1),
                                      random() % 4 == 0 ? 0 : uniform(random, -1, 1), 1e-3};
        const double begin = uniform(random, 0, 0.5);
        const double end = uniform(random, begin, 1);
        const double place = q.place_of_least(begin, end);
        ASSERT_GE(place, begin);
        ASSERT_LE(place, end);
        ASSERT_EQ(q.least(begin, end), q.at(place) - q.error);
        for (int k = 0; k <= 100; ++k) {
            ASSERT_LE(q.at(place), q.at(begin + (end - begin) * k / 100) + 1e-15);
        }
    }
}

}  // namespace
}  // namespace asv::core
