#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/free_plane/free_plane.hpp"
#include "tests/geometry/unit_and_infinity.hpp"
#include "tests/kit/geometry/random_boxes.hpp"
#include "tests/kit/geometry/visibility_oracle.hpp"
#include "tests/kit/scaled.hpp"

/// Random scenes, of five boxes to a hundred thousand, against brute force and each other.

namespace asv::geometry {
namespace {

Point anywhere(test::Random& random) {
    const double x = random.uniform(0, 1);
    return {x, random.uniform(0, 1)};
}

TEST(FreePlane, AgreesWithBruteForceInGeneralPosition) {
    for (std::uint64_t seed = 1; seed <= test::scaled(400); ++seed) {
        test::Random random(seed);
        const std::vector<Box> boxes = test::random_boxes(random, 5 + seed % 40, 0.25);
        FreePlane space(boxes, unit);
        for (int i = 0; i < 4; ++i) {
            const Point from = anywhere(random);
            const Point to = anywhere(random);
            if (!space.is_free(from) || !space.is_free(to)) continue;
            const double expected = test::brute_force_shortest_path(boxes, unit, from, to, 0);
            const double found = space.shortest_path(from, to);
            if (std::isinf(expected)) {
                ASSERT_EQ(found, infinity) << "seed " << seed << ", pair " << i;
            } else {
                ASSERT_NEAR(found, expected, 1e-11) << "seed " << seed << ", pair " << i;
            }
        }
    }
}

TEST(FreePlane, AnotherBoxNeverShortens) {
    for (std::uint64_t seed = 1; seed <= test::scaled(100); ++seed) {
        test::Random random(seed);
        const std::vector<Box> boxes = test::random_boxes(random, 30, 0.25);
        const Point from = anywhere(random);
        const Point to = anywhere(random);
        double before = 0;
        for (std::size_t count = 0; count <= boxes.size(); ++count) {
            const double now =
                FreePlane(std::span(boxes).first(count), unit).shortest_path(from, to);
            ASSERT_GE(now, before * (1 - 1e-13)) << "seed " << seed << ", " << count << " boxes";
            before = now;
        }
    }
}

TEST(FreePlane, LaterQuestionsGetTheSameAnswers) {
    for (std::uint64_t seed = 1; seed <= test::scaled(100); ++seed) {
        test::Random random(seed);
        const std::vector<Box> boxes = test::random_boxes(random, 60, 0.2);
        FreePlane kept(boxes, unit);
        for (int i = 0; i < 10; ++i) {
            const Point from = anywhere(random);
            const Point to = anywhere(random);
            ASSERT_EQ(kept.shortest_path(from, to), FreePlane(boxes, unit).shortest_path(from, to))
                << "seed " << seed << ", pair " << i;
        }
    }
}

TEST(FreePlane, LessEffortBoundsFromBelow) {
    test::Random random(3);
    FreePlane space(test::random_boxes(random, 2000, 0.02), unit);
    const Point from{0.01, 0.02};
    const Point to{0.99, 0.98};
    const double exact = space.shortest_path(from, to);
    ASSERT_TRUE(std::isfinite(exact));
    double before = std::hypot(0.98, 0.96);
    for (std::size_t effort = 0; effort < 1'000'000; effort = 2 * effort + 1) {
        const double now = space.shortest_path_at_least(from, to, effort);
        ASSERT_GE(now, before * (1 - 1e-13));
        ASSERT_LE(now, exact * (1 + 1e-13));
        before = now;
    }
    EXPECT_EQ(before, exact);
    EXPECT_LT(space.shortest_path_at_least(from, to, 10), exact);
}

TEST(FreePlane, ManyBoxes) {
    for (const double largest : {0.0005, 0.003, 0.02}) {
        test::Random random(5);
        FreePlane space(test::random_boxes(random, 100'000, largest), unit);
        const Point from{0.1, 0.1};
        const Point to{0.9, 0.8};
        const double length = space.shortest_path_at_least(from, to, 200'000);
        EXPECT_EQ(std::isfinite(length), space.connected(from, to));
        EXPECT_GE(length, std::hypot(0.8, 0.7));
    }
    test::Random random(5);
    FreePlane space(test::random_boxes(random, 100'000, 0.0005), unit);
    const double length = space.shortest_path({0.1, 0.1}, {0.9, 0.8});
    ASSERT_TRUE(std::isfinite(length));
    EXPECT_NEAR(space.shortest_path({0.9, 0.8}, {0.1, 0.1}), length, 1e-12);
}

}  // namespace
}  // namespace asv::geometry
