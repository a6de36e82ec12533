#include "geometry/predicates/orientation.hpp"

#include <gtest/gtest.h>

#include "tests/kit/geometry/adversary.hpp"
#include "tests/kit/geometry/exact_oracle.hpp"
#include "tests/kit/scaled.hpp"

namespace asv::geometry {
namespace {

using test::Adversary;

TEST(Orientation, KnownTriangles) {
    EXPECT_EQ(orientation({0, 0}, {1, 0}, {0, 1}), 1);
    EXPECT_EQ(orientation({0, 0}, {0, 1}, {1, 0}), -1);
    EXPECT_EQ(orientation({0, 0}, {1, 1}, {3, 3}), 0);
    EXPECT_EQ(orientation({0.1, 0.1}, {0.1, 0.1}, {5, 7}), 0);
}

// 0.1, 0.2 and 0.3 are not equidistant in binary, so these points are not collinear.
TEST(Orientation, SeesTheRoundingOfDecimals) {
    EXPECT_EQ(orientation({0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3}), 0);
    EXPECT_NE(orientation({0.1, 0}, {0.2, 1}, {0.3, 2}), 0);
}

TEST(Orientation, AgreesWithRationalArithmetic) {
    constexpr std::uint64_t seed = 20240601;
    Adversary draw(seed);
    std::size_t degenerate = 0;
    const std::size_t count = test::scaled(1'000'000);
    for (std::size_t i = 0; i < count; ++i) {
        const auto [a, b, c] = draw.triple();
        const int expected = test::exact_orientation(a, b, c);
        if (expected == 0) ++degenerate;
        ASSERT_EQ(orientation(a, b, c), expected) << "seed " << seed << ", case " << i;
        ASSERT_EQ(orientation(b, c, a), expected) << "seed " << seed << ", case " << i;
        ASSERT_EQ(orientation(b, a, c), -expected) << "seed " << seed << ", case " << i;
    }
    EXPECT_GT(degenerate, count / 10) << "the generator misses the hard cases";
}

}  // namespace
}  // namespace asv::geometry
