#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/kit/geometry/adversary.hpp"
#include "tests/kit/geometry/scalar_sin_cos.hpp"
#include "tests/kit/scaled.hpp"

namespace asv::geometry {
namespace {

using test::Adversary;

// The reference is long double, whose own error is below 1e-19 here.
TEST(SinCos, KeepsTheStatedError) {
    constexpr std::uint64_t seed = 3;
    Adversary draw(seed);
    for (std::size_t i = 0; i < test::scaled(1'000'000); ++i) {
        const double range = std::ldexp(1, draw.pick(21));
        const double angle = draw.uniform(-range, range);
        const auto [sine, cosine] = test::scalar_sin_cos(angle);
        ASSERT_LT(std::fabs(sine - std::sin(static_cast<long double>(angle))), 3e-16L) << angle;
        ASSERT_LT(std::fabs(cosine - std::cos(static_cast<long double>(angle))), 3e-16L) << angle;
    }
}

TEST(SinCos, KnownAngles) {
    EXPECT_EQ(test::scalar_sin_cos(0).sin, 0);
    EXPECT_EQ(test::scalar_sin_cos(0).cos, 1);
    EXPECT_EQ(test::scalar_sin_cos(std::numbers::pi / 2).sin, 1);
    EXPECT_EQ(test::scalar_sin_cos(-std::numbers::pi / 2).sin, -1);
    EXPECT_EQ(test::scalar_sin_cos(std::numbers::pi).cos, -1);
}

}  // namespace
}  // namespace asv::geometry
