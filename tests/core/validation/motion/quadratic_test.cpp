#include "core/validation/motion/quadratic.hpp"

#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "core/model/problem.hpp"
#include "tests/kit/random.hpp"
#include "tests/kit/scaled.hpp"

namespace asv::core {
namespace {

using test::Random;
using validation::Moving;

TEST(Quadratic, CoversTheTrueProductsWithItsError) {
    Random random(6);
    for (std::size_t i = 0; i < test::scaled(20'000); ++i) {
        SCOPED_TRACE("seed 6, case " + std::to_string(i));
        const double size = std::pow(10, random.uniform(-9, 3));
        const auto point = [&] {
            return Point{random.uniform(0.3, 0.7) + random.uniform(-size, size),
                         random.uniform(0.3, 0.7) + random.uniform(-size, size)};
        };
        const std::array<Moving, 4> p = {Moving{point(), point()}, Moving{point(), point()},
                                         Moving{point(), point()}, Moving{point(), point()}};
        const double t = random.uniform(0, 1);
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
    Random random(7);
    for (std::size_t i = 0; i < test::scaled(5000); ++i) {
        SCOPED_TRACE("seed 7, case " + std::to_string(i));
        const validation::Quadratic q{random.uniform(-1, 1), random.uniform(-1, 1),
                                      random.one_in(4) ? 0 : random.uniform(-1, 1), 1e-3};
        const double begin = random.uniform(0, 0.5);
        const double end = random.uniform(begin, 1);
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
