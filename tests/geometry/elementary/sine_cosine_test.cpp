#include "geometry/elementary/sine_cosine.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/kit/seeds.hpp"

namespace asv::elementary {
namespace {

using core::Rng;

void expect_right(const std::vector<double>& angles) {
    std::vector<double> sine(angles.size()), cosine(angles.size());
    sine_cosine(angles, sine, cosine);
    for (std::size_t i = 0; i < angles.size(); ++i) {
        // The reference is long double, whose own error does not count.
        const auto angle = static_cast<long double>(angles[i]);
        ASSERT_LE(std::abs(static_cast<long double>(sine[i]) - std::sin(angle)), 2e-16L) << angle;
        ASSERT_LE(std::abs(static_cast<long double>(cosine[i]) - std::cos(angle)), 2e-16L) << angle;
    }
}

TEST(SineCosine, AgreesWithTheLibrary) {
    test::for_seeds(10, [](Rng& rng) {
        std::vector<double> angles;
        for (const double range : {0.8, 4.0, 100.0, 99999.0})
            for (int i = 0; i < 10000; ++i) angles.push_back(rng.uniform(-range, range));
        expect_right(angles);
    });
}

TEST(SineCosine, AgreesNearMultiplesOfAnEighthTurn) {
    std::vector<double> angles{0.0, -0.0, 1e-300, 5e-324};
    for (int i = -2000; i <= 2000; ++i) {
        double angle = i * std::numbers::pi / 4;
        for (int ulp = 0; ulp < 3; ++ulp) {
            angles.push_back(angle);
            angle = std::nextafter(angle, 1e9);
        }
    }
    expect_right(angles);
}

TEST(SineCosine, EveryLengthGivesTheSameBits) {
    Rng rng(1);
    std::vector<double> angles(37);
    for (double& angle : angles) angle = rng.uniform(-10, 10);
    std::vector<double> sine(37), cosine(37), one_sine(1), one_cosine(1);
    for (std::size_t count = 0; count <= 37; ++count) {
        const std::span<const double> in{angles.data(), count};
        sine_cosine(in, {sine.data(), count}, {cosine.data(), count});
        for (std::size_t i = 0; i < count; ++i) {
            sine_cosine({angles.data() + i, 1}, one_sine, one_cosine);
            ASSERT_EQ(sine[i], one_sine[0]);
            ASSERT_EQ(cosine[i], one_cosine[0]);
        }
    }
}

}  // namespace
}  // namespace asv::elementary
