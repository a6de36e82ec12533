#include <limits>
#include <map>

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "core/validation/collisions.hpp"
#include "geometry/predicates/distance.hpp"
#include "geometry/predicates/segment_box.hpp"
#include "tests/core/validation/tolerance.hpp"
#include "tests/kit/chains/paths.hpp"
#include "tests/kit/chains/random_chains.hpp"
#include "tests/kit/chains/reference_tester.hpp"
#include "tests/kit/check_results.hpp"
#include "tests/kit/geometry/random_boxes.hpp"
#include "tests/kit/scaled.hpp"

/// The validator against the plain tester, against brute force and under symmetries.

namespace asv::core {
namespace {

using test::Points;
using test::Random;

std::vector<Check> failures(const Problem& problem, const Points& chain, double tolerance = e) {
    return test::failed(validate_state(problem, chain, {.tolerance = tolerance}).checks);
}

TEST(Oracle, VerdictsAreThoseOfThePlainTester) {
    constexpr std::array sizes = {0.0, 1e-16, 3e-6, 1e-5, 3e-5};
    std::map<std::size_t, std::size_t> seen;
    Random random(1);
    for (std::size_t i = 0; i < test::scaled(50'000); ++i) {
        SCOPED_TRACE("seed 1, case " + std::to_string(i));
        Problem problem;
        problem.obstacles = test::random_boxes_some_thin(random, random.below(12), 0.3);
        Points chain = test::random_chain(random, 2 + random.below(12));
        test::shake(random, chain, sizes[random.below(sizes.size())]);
        const double tolerance = random.one_in(4) ? random.uniform(0, 1e-3) : e;
        const auto expected = test::reference_failures(chain, problem.obstacles, tolerance);
        ASSERT_EQ(failures(problem, chain, tolerance), expected);
        for (const Check check : expected) ++seen[static_cast<std::size_t>(check)];
        if (expected.empty()) ++seen[0];
    }
    // Each verdict has been among the cases, so that agreeing means something.
    for (const Check check : {Check::ends, Check::broom_lengths, Check::convexity, Check::area,
                              Check::bounds, Check::collisions}) {
        EXPECT_GT(seen[static_cast<std::size_t>(check)], test::scaled(200));
    }
}

TEST(Oracle, TheTightestStateIsThatOfBruteForce) {
    Random random(2);
    for (std::size_t i = 0; i < test::scaled(300); ++i) {
        SCOPED_TRACE("seed 2, case " + std::to_string(i));
        Problem problem;
        problem.obstacles = test::random_boxes_some_thin(random, 1 + random.below(100), 0.05);
        std::vector<Points> states;
        for (int k = 0; k < 5; ++k) states.push_back(test::random_chain(random, 5));
        problem.start = problem.goal = states[0];
        std::size_t collisions = 0;
        double least = std::numeric_limits<double>::infinity();
        for (const Points& state : states) {
            bool meets = false;
            for (std::size_t b = 0; b + 1 < state.size(); ++b) {
                for (const Box& box : problem.obstacles) {
                    const Box shrunk = geometry::grown(box, -e);
                    if (geometry::is_empty(shrunk)) continue;
                    const validation::Finding finding =
                        validation::clearance({state[b], state[b + 1]}, shrunk);
                    least = std::min(least, finding.offender.room);
                    meets = meets || !finding.ok;
                }
            }
            collisions += meets ? 1 : 0;
        }
        const ValidationReport report = validate(problem, {test::path_of(states), 0});
        const CheckResult& result = test::find(report.checks, Check::collisions);
        ASSERT_EQ(result.failures, collisions);
        ASSERT_EQ(result.worst ? result.worst->room : std::numeric_limits<double>::infinity(),
                  least);
    }
}

TEST(Oracle, PenetrationIsTheLeastShiftThatParts) {
    Random random(3);
    for (std::size_t i = 0; i < test::scaled(2000); ++i) {
        SCOPED_TRACE("seed 3, case " + std::to_string(i));
        const Box box{{0, 0}, {random.uniform(0.01, 1), random.uniform(0.01, 1)}};
        const geometry::Segment segment{{random.uniform(-1, 1), random.uniform(-1, 1)},
                                        {random.uniform(-1, 1), random.uniform(-1, 1)}};
        if (!geometry::meets(segment, box)) continue;
        const double depth = validation::penetration(segment, box);
        bool parted = false;
        for (int k = 0; k < 3600; ++k) {
            const double angle = k * std::numbers::pi / 1800;
            const auto parts = [&](double shift) {
                const double dx = shift * std::cos(angle);
                const double dy = shift * std::sin(angle);
                return !geometry::meets(
                    {{segment.a.x + dx, segment.a.y + dy}, {segment.b.x + dx, segment.b.y + dy}},
                    box);
            };
            ASSERT_FALSE(parts(depth * (1 - 1e-9))) << angle;
            parted = parted || parts(depth * (1 + 1e-5) + 1e-12);
        }
        ASSERT_TRUE(parted);
    }
}

RC_GTEST_PROP(Symmetry, VerdictsDoNotDependOnDirectionOrSide, (std::uint64_t seed)) {
    Random random(seed);
    Problem problem;
    problem.obstacles = test::random_boxes_some_thin(random, 6, 0.3);
    // Coordinates of few bits are mirrored and turned without rounding.
    const auto rounded = [](double value) { return std::round(value * 0x1p30) * 0x1p-30; };
    Points chain = test::random_chain(random, 3 + random.below(8));
    for (Point& point : chain) point = {rounded(point.x), rounded(point.y)};
    for (Box& box : problem.obstacles) {
        box = {{rounded(box.low.x), rounded(box.low.y)},
               {rounded(box.high.x), rounded(box.high.y)}};
    }
    const double tolerance = 0x1p-17;
    auto verdict = [&](const Problem& p, const Points& c) {
        std::vector<Check> checks = failures(p, c, tolerance);
        // The bounds alone are no mirror image of themselves.
        std::erase(checks, Check::bounds);
        return checks;
    };
    const std::vector<Check> expected = verdict(problem, chain);
    RC_ASSERT(verdict(problem, Points(chain.rbegin(), chain.rend())) == expected);
    Problem mirrored = problem;
    Points mirrored_chain = chain;
    for (Point& point : mirrored_chain) point.x = -point.x;
    for (Box& box : mirrored.obstacles) {
        box = {{-box.high.x, box.low.y}, {-box.low.x, box.high.y}};
    }
    RC_ASSERT(verdict(mirrored, mirrored_chain) == expected);
    Problem swapped = problem;
    Points swapped_chain = chain;
    for (Point& point : swapped_chain) std::swap(point.x, point.y);
    for (Box& box : swapped.obstacles) {
        std::swap(box.low.x, box.low.y);
        std::swap(box.high.x, box.high.y);
    }
    RC_ASSERT(verdict(swapped, swapped_chain) == expected);
}

}  // namespace
}  // namespace asv::core
