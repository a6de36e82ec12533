#include "geometry/elementary/functions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/kit/seeds.hpp"

/// References are functions of long double, which has eleven digits more.

namespace asv::elementary {
namespace {

using core::Rng;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double least_number = std::numeric_limits<double>::denorm_min();
constexpr int draws = 20000;

/// By how many units in the last place of the right value another one is off.
long double ulps_off(double found, long double right) {
    if (found == right) return 0;
    constexpr int digits = std::numeric_limits<double>::digits;
    const int exponent = std::max(std::ilogb(right), std::numeric_limits<double>::min_exponent - 1);
    return std::abs(found - right) / std::ldexp(1.0L, exponent + 1 - digits);
}

/// Of any size, as likely 1e-300 as 1e300, or nearly so small and large as numbers are.
double of_any_size(Rng& rng) {
    const double mantissa = rng.uniform(1, 2);
    return std::ldexp(rng.chance(0.5) ? mantissa : -mantissa,
                      static_cast<int>(rng.below(2044)) - 1020);
}

TEST(ElementaryFunctions, SineAndCosine) {
    test::for_seeds(10, [](Rng& rng) {
        const auto expect_right = [](double angle) {
            EXPECT_LE(ulps_off(elementary::sin(angle), std::sin(static_cast<long double>(angle))),
                      0.51L)
                << angle;
            EXPECT_LE(ulps_off(elementary::cos(angle), std::cos(static_cast<long double>(angle))),
                      0.51L)
                << angle;
        };
        for (int i = 0; i < draws; ++i) {
            expect_right(rng.uniform(-8, 8));
            expect_right(std::ldexp(rng.uniform(-1, 1), -static_cast<int>(rng.below(1000))));
        }
        for (int eighth = -10; eighth <= 10; ++eighth) expect_right(eighth * std::numbers::pi / 4);
    });
}

TEST(ElementaryFunctions, SineAndCosineOfManyTurns) {
    test::for_seeds(10, [](Rng& rng) {
        for (int i = 0; i < draws; ++i) {
            const double angle = std::ldexp(rng.uniform(-1, 1), static_cast<int>(rng.below(41)));
            const long double exact = angle;
            ASSERT_LE(std::abs(elementary::sin(angle) - std::sin(exact)), 0x0.83p-53L) << angle;
            ASSERT_LE(std::abs(elementary::cos(angle) - std::cos(exact)), 0x0.83p-53L) << angle;
        }
    });
    for (const double angle : {0x1p40, -0x1p40, infinity, not_a_number}) {
        EXPECT_TRUE(std::isnan(elementary::sin(angle)));
        EXPECT_TRUE(std::isnan(elementary::cos(angle)));
    }
    EXPECT_TRUE(std::signbit(elementary::sin(-0.0)));
    EXPECT_EQ(elementary::cos(0), 1);
}

TEST(ElementaryFunctions, Tangent) {
    test::for_seeds(10, [](Rng& rng) {
        for (int i = 0; i < draws; ++i) {
            const double angle = rng.uniform(-8, 8);
            ASSERT_LE(ulps_off(elementary::tan(angle), std::tan(static_cast<long double>(angle))),
                      2)
                << angle;
        }
    });
}

TEST(ElementaryFunctions, ArcTangent) {
    test::for_seeds(10, [](Rng& rng) {
        const auto expect_right = [](double y, double x) {
            const long double right =
                std::atan2(static_cast<long double>(y), static_cast<long double>(x));
            const bool normal = std::abs(right) >= std::numeric_limits<double>::min();
            ASSERT_LE(ulps_off(elementary::atan2(y, x), right), normal ? 0.51L : 1)
                << y << ' ' << x;
        };
        for (int i = 0; i < draws; ++i) {
            expect_right(rng.uniform(-1, 1), rng.uniform(-1, 1));
            expect_right(of_any_size(rng), of_any_size(rng));
            const double x = of_any_size(rng);
            expect_right(x * rng.uniform(-3, 3), x);
            expect_right(x * std::ldexp(rng.uniform(-1, 1), -static_cast<int>(rng.below(80))), x);
        }
    });
}

TEST(ElementaryFunctions, ArcTangentAtTheEdges) {
    const double edges[] = {0.0,     least_number, 0x1p-1022, 1.0,        0x1p-30,
                            0x1p-31, 0x1p900,      0x1p-900,  0x1.8p1023, infinity};
    for (const double a : edges)
        for (const double b : edges)
            for (const double y : {a, -a})
                for (const double x : {b, -b}) {
                    const auto right = static_cast<double>(
                        std::atan2(static_cast<long double>(y), static_cast<long double>(x)));
                    EXPECT_EQ(elementary::atan2(y, x), right) << y << ' ' << x;
                    EXPECT_EQ(std::signbit(elementary::atan2(y, x)), std::signbit(right))
                        << y << ' ' << x;
                }
    EXPECT_TRUE(std::isnan(elementary::atan2(not_a_number, 1)));
    EXPECT_TRUE(std::isnan(elementary::atan2(1, not_a_number)));
}

TEST(ElementaryFunctions, ArcSine) {
    test::for_seeds(10, [](Rng& rng) {
        for (int i = 0; i < draws; ++i) {
            const double off = std::ldexp(rng.uniform(), -static_cast<int>(rng.below(50)));
            for (const double sine : {off, -off, 1 - off, off - 1})
                ASSERT_LE(
                    ulps_off(elementary::asin(sine), std::asin(static_cast<long double>(sine))), 3)
                    << sine;
        }
    });
    EXPECT_EQ(elementary::asin(0), 0);
    EXPECT_EQ(elementary::asin(1), std::numbers::pi / 2);
    EXPECT_TRUE(std::isnan(elementary::asin(1.5)));
}

TEST(ElementaryFunctions, Length) {
    test::for_seeds(10, [](Rng& rng) {
        const auto expect_right = [](double x, double y) {
            const long double right =
                std::hypot(static_cast<long double>(x), static_cast<long double>(y));
            if (right > std::numeric_limits<double>::max()) return;
            ASSERT_LE(ulps_off(elementary::hypot(x, y), right), 1) << x << ' ' << y;
        };
        for (int i = 0; i < draws; ++i) {
            expect_right(rng.uniform(-1, 1), rng.uniform(-1, 1));
            expect_right(of_any_size(rng), of_any_size(rng));
            const double x = of_any_size(rng);
            expect_right(x, x * std::ldexp(rng.uniform(-1, 1), -static_cast<int>(rng.below(60))));
        }
    });
    EXPECT_EQ(elementary::hypot(3, -4), 5);
    EXPECT_EQ(elementary::hypot(0, 0), 0);
    EXPECT_EQ(elementary::hypot(least_number, 0), least_number);
    EXPECT_EQ(elementary::hypot(0x1p1023, 0x1p1023 * 1.75), infinity);
    EXPECT_EQ(elementary::hypot(-infinity, not_a_number), infinity);
    EXPECT_TRUE(std::isnan(elementary::hypot(not_a_number, 1)));
}

TEST(ElementaryFunctions, Logarithm) {
    test::for_seeds(10, [](Rng& rng) {
        const auto expect_right = [](double value) {
            ASSERT_LE(ulps_off(elementary::log(value), std::log(static_cast<long double>(value))),
                      0.51L)
                << value;
        };
        for (int i = 0; i < draws; ++i) {
            expect_right(std::abs(of_any_size(rng)));
            expect_right(1 - rng.uniform());
            expect_right(1 + std::ldexp(rng.uniform(-1, 1), -static_cast<int>(rng.below(52))));
            expect_right(least_number * static_cast<double>(1 + rng.below(1000)));
        }
    });
    EXPECT_EQ(elementary::log(1), 0);
    EXPECT_EQ(elementary::log(0), -infinity);
    EXPECT_EQ(elementary::log(infinity), infinity);
    EXPECT_TRUE(std::isnan(elementary::log(-1)));
    EXPECT_TRUE(std::isnan(elementary::log(not_a_number)));
}

TEST(ElementaryFunctions, Exponential) {
    test::for_seeds(10, [](Rng& rng) {
        for (int i = 0; i < draws; ++i) {
            const double small = std::ldexp(rng.uniform(-1, 1), -static_cast<int>(rng.below(60)));
            for (const double exponent : {small, rng.uniform(-708, 709), rng.uniform(-745, -709)}) {
                const long double right = std::exp(static_cast<long double>(exponent));
                const bool normal = right >= std::numeric_limits<double>::min();
                ASSERT_LE(ulps_off(elementary::exp(exponent), right), normal ? 0.52L : 1)
                    << exponent;
            }
        }
    });
    EXPECT_EQ(elementary::exp(0), 1);
    EXPECT_EQ(elementary::exp(-infinity), 0);
    EXPECT_EQ(elementary::exp(-746), 0);
    EXPECT_EQ(elementary::exp(709.8), infinity);
    EXPECT_EQ(elementary::exp(infinity), infinity);
    EXPECT_TRUE(std::isnan(elementary::exp(not_a_number)));
}

TEST(ElementaryFunctions, Power) {
    test::for_seeds(10, [](Rng& rng) {
        const auto expect_right = [](double base, double exponent) {
            const long double right =
                std::pow(static_cast<long double>(base), static_cast<long double>(exponent));
            if (right > std::numeric_limits<double>::max() ||
                right < std::numeric_limits<double>::min())
                return;
            ASSERT_LE(ulps_off(elementary::pow(base, exponent), right), 0.52L)
                << base << ' ' << exponent;
        };
        for (int i = 0; i < draws; ++i) {
            expect_right(1 - rng.uniform(), 1 / static_cast<double>(1 + rng.below(40)));
            expect_right(rng.uniform(0, 10), rng.uniform(-10, 10));
            expect_right(std::abs(of_any_size(rng)), rng.uniform(-1, 1));
            expect_right(1 + std::ldexp(rng.uniform(-1, 1), -40),
                         std::ldexp(rng.uniform(-1, 1), 49));
        }
    });
    EXPECT_EQ(elementary::pow(3, 4), 81);
    EXPECT_EQ(elementary::pow(0, 0), 1);
    EXPECT_EQ(elementary::pow(0, 2), 0);
    EXPECT_EQ(elementary::pow(0, -2), infinity);
    EXPECT_EQ(elementary::pow(1, infinity), 1);
    EXPECT_EQ(elementary::pow(0.5, infinity), 0);
    EXPECT_EQ(elementary::pow(2, 0x1p1000), infinity);
    EXPECT_EQ(elementary::pow(infinity, -1), 0);
    EXPECT_TRUE(std::isnan(elementary::pow(2, not_a_number)));
}

}  // namespace
}  // namespace asv::elementary
