#include "core/shapes/chain_shapes.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "core/model/problem.hpp"
#include "core/shapes/flat_chain.hpp"
#include "core/validation/validate.hpp"
#include "geometry/predicates/polygon.hpp"
#include "tests/kit/files/error_message.hpp"

namespace asv::core {
namespace {

using Points = std::vector<Point>;
constexpr double pi = std::numbers::pi;

/// The chain alone in an endless plane.
ValidationReport report_of(const Points& chain, const Requirements& requirements) {
    Problem alone{chain, chain, {}, requirements};
    alone.requirements.bounds = without_bounds();
    return validate_state(alone, chain, {.tolerance = requirements.tolerance});
}

Requirements scaled(double factor) {
    Requirements requirements;
    for (double* length : {&requirements.broom_length, &requirements.max_step,
                           &requirements.area_radius_per_broom, &requirements.tolerance})
        *length *= factor;
    return requirements;
}

double heading(const Point& from, const Point& to) {
    return std::atan2(to.y - from.y, to.x - from.x);
}

TEST(ChainShapes, MeetTheRequirementsForEveryNumberOfAsvs) {
    for (const double factor : {1.0, 2000.0, 1e-3}) {
        const Requirements requirements = scaled(factor);
        for (const std::size_t n : {1U, 3U, 4U, 5U, 6U, 7U, 15U, 50U, 200U}) {
            for (const bool clockwise : {false, true}) {
                const ShapePlace place{{3, -4}, 0.7, clockwise};
                for (const Points& chain :
                     {line_chain(n, requirements, place), arc_chain(n, requirements, place),
                      hook_chain(n, requirements, place)}) {
                    ASSERT_EQ(chain.size(), n);
                    EXPECT_EQ(chain.front(), place.first);
                    EXPECT_TRUE(report_of(chain, requirements).valid()) << n << ' ' << factor;
                    if (n == 1) continue;
                    EXPECT_EQ(geometry::signed_area(chain) < 0, clockwise) << n;
                    // Not by the tolerance alone.
                    EXPECT_GE(std::abs(geometry::signed_area(chain)), requirements.min_area(n));
                }
            }
        }
    }
}

TEST(ChainShapes, LieWhereTheirHeadingLeads) {
    for (const bool clockwise : {false, true}) {
        const ShapePlace place{{0.1, 0.2}, 0.4, clockwise};
        const Points line = line_chain(7, {}, place), arc = arc_chain(7, {}, place, pi),
                     hook = hook_chain(7, {}, place);
        EXPECT_NEAR(heading(line.front(), line.back()), 0.4, 1e-12);
        EXPECT_NEAR(heading(arc.front(), arc.back()), 0.4, 1e-12);
        // Half of its brooms lead ahead.
        for (std::size_t i = 1; i <= 3; ++i) EXPECT_NEAR(heading(hook[0], hook[i]), 0.4, 1e-12);
        EXPECT_GT(std::abs(heading(hook[3], hook[4]) - 0.4), 0.1);
    }
}

TEST(ChainShapes, ALineIsHardlyHigherThanAnyChainMustBe) {
    const Points chain = line_chain(7, {}, {{0, 0}, 0, true});
    double high = 0;
    for (const Point& point : chain) high = std::max(high, point.y);
    EXPECT_GT(high, min_flat_height(7));
    EXPECT_LT(high, 1.03 * min_flat_height(7));
    // Where no area is asked for, it still turns at its ends.
    Requirements thin;
    thin.area_radius_per_broom = 0;
    EXPECT_TRUE(report_of(line_chain(3, thin, {}), thin).valid());
}

TEST(ChainShapes, AnArcAndAHookBendAsFarAsTheyAreTold) {
    const Points arc = arc_chain(12, {}, {}, 1.5 * pi);
    EXPECT_NEAR(
        std::remainder(heading(arc[10], arc[11]) - heading(arc[0], arc[1]) - 1.5 * pi, 2 * pi), 0,
        1e-12);
    const Points hook = hook_chain(12, {}, {}, pi, 7);
    EXPECT_NEAR(heading(hook[0], hook[7]), 0, 1e-12);
    EXPECT_NEAR(std::abs(heading(hook[10], hook[11])), pi, 1e-12);
    EXPECT_GT(heading(hook[7], hook[8]), 0.1);
}

TEST(ChainShapes, SayWhichRequirementTheyWouldViolate) {
    const auto message = [](auto shape) {
        return test::error_message<std::invalid_argument>(shape);
    };
    EXPECT_EQ(message([] { line_chain(2, {}, {}); }), "2 ASVs enclose no area");
    EXPECT_EQ(message([] { arc_chain(0, {}, {}); }), "0 ASVs enclose no area");
    EXPECT_NE(message([] { arc_chain(7, {}, {}, 0.01); }).find("the area is too small by 0.005"),
              std::string::npos);
    EXPECT_NE(message([] { arc_chain(5, {}, {}, 1.9 * pi); }).find("more than 3 pi"),
              std::string::npos);
    EXPECT_EQ(message([] { hook_chain(4, {}, {}, 1, 3); }),
              "a leg of 3 of 3 brooms leaves none on one side");
    EXPECT_EQ(message([] { hook_chain(4, {}, {}, 1, 0); }),
              "a leg of 0 of 3 brooms leaves none on one side");
    Requirements vast;
    vast.area_radius_per_broom = 0.05;
    EXPECT_EQ(message([&] { line_chain(7, vast, {}); }),
              "flat chain: the minimum area is too large for a flat shape");
}

}  // namespace
}  // namespace asv::core
