#include "core/generate/families.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "core/shapes/flat_chain.hpp"
#include "core/validation/validate.hpp"
#include "geometry/predicates/distance.hpp"
#include "geometry/predicates/polygon.hpp"

namespace asv::core {
namespace {

// One problem of a family, for any chain.
struct Case {
    std::string name;
    std::vector<std::size_t> asv_counts;
    std::function<Problem(const ChainOptions&, Rng&)> draw;
};

template <class Options>
Case make_case(std::string name, std::vector<std::size_t> asv_counts,
               Problem (*draw)(const Options&, Rng&), std::function<void(Options&)> change = {}) {
    return {std::move(name), std::move(asv_counts),
            [draw, change](const ChainOptions& chain, Rng& rng) {
                Options options;
                if (change) change(options);
                options.chain = chain;
                return draw(options, rng);
            }};
}

std::vector<Case> cases() {
    std::vector<Case> all{
        make_case<CorridorOptions>("corridor", {3, 4, 7, 10, 12, 15, 20}, corridor),
        make_case<CorridorOptions>("corridor_tight", {4, 7, 10}, corridor,
                                   [](auto& options) { options.height.factor = 1.01; }),
        make_case<CorridorOptions>("corridor_low", {12, 16, 20}, corridor,
                                   [](auto& options) { options.height.absolute = 0.015; }),
        make_case<BendOptions>("bend", {3, 7, 10}, bend),
        make_case<GauntletOptions>("gauntlet", {3, 7, 10, 15}, gauntlet),
        make_case<GauntletOptions>("gauntlet_three", {3, 7, 10}, gauntlet,
                                   [](auto& options) { options.walls = 3; }),
        make_case<RoomsOptions>("rooms", {3, 7, 15}, rooms),
        make_case<MazeOptions>("maze", {3, 5, 8, 12, 16}, maze),
        make_case<SpiralOptions>("spiral", {3, 5, 7}, spiral),
        make_case<CrossingOptions>("crossing", {3, 15, 20, 25, 40, 50}, crossing),
        make_case<ClutterOptions>("clutter", {3, 10, 25}, clutter),
        make_case<ClutterOptions>("clutter_dense", {3, 10, 25}, clutter,
                                  [](auto& options) { options.obstacles = 2000; }),
        make_case<ClutterOptions>("clutter_sparse", {30, 40, 50}, clutter, [](auto& options) {
            options.obstacles = 3;
            options.density = 0.02;
            options.lane = 0;
        })};
    for (const std::size_t bends : {1u, 3u, 4u}) {
        all.push_back(make_case<BendOptions>("bend_" + std::to_string(bends), {3, 7}, bend,
                                             [bends](auto& options) { options.bends = bends; }));
    }
    return all;
}

class Families : public testing::TestWithParam<Case> {
  protected:
    template <class Body>
    void for_each_problem(std::uint64_t seeds, const Body& body) {
        for (const std::size_t n : GetParam().asv_counts) {
            for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
                SCOPED_TRACE(GetParam().name + ", n " + std::to_string(n) + ", seed " +
                             std::to_string(seed));
                ChainOptions chain;
                chain.asv_count = n;
                body(chain, seed);
            }
        }
    }
    Problem draw(const ChainOptions& chain, std::uint64_t seed) {
        Rng rng(seed);
        return GetParam().draw(chain, rng);
    }
};

INSTANTIATE_TEST_SUITE_P(All, Families, testing::ValuesIn(cases()),
                         [](const auto& test) { return test.param.name; });

std::string failures(const ValidationReport& report) {
    std::string text;
    for (const CheckResult& check : report.checks) {
        if (!check.ok()) text += describe(check) + "; ";
    }
    return text;
}

TEST_P(Families, StartAndGoalMeetEveryRequirement) {
    for_each_problem(8, [&](const ChainOptions& chain, std::uint64_t seed) {
        const Problem problem = draw(chain, seed);
        ASSERT_EQ(problem.start.size(), chain.asv_count);
        ASSERT_EQ(problem.goal.size(), chain.asv_count);
        for (const auto* end : {&problem.start, &problem.goal}) {
            EXPECT_EQ(failures(validate_state(problem, *end, {.tolerance = 1e-9})), "");
        }
    });
}

TEST_P(Families, StartAndGoalKeepTheirClearance) {
    for_each_problem(3, [&](ChainOptions chain, std::uint64_t seed) {
        chain.clearance = 0.003;
        const Problem problem = draw(chain, seed);
        for (const auto* end : {&problem.start, &problem.goal}) {
            for (std::size_t i = 0; i + 1 < end->size(); ++i) {
                const geometry::Segment broom{(*end)[i], (*end)[i + 1]};
                for (const Box& box : problem.obstacles)
                    ASSERT_GT(geometry::distance(broom, box), chain.clearance);
            }
            for (const Point& point : *end) {
                ASSERT_GE(std::min({point.x, point.y, 1 - point.x, 1 - point.y}),
                          chain.clearance - 1e-12);
            }
        }
    });
}

TEST_P(Families, SameSeedGivesTheSameProblem) {
    for_each_problem(2, [&](const ChainOptions& chain, std::uint64_t seed) {
        const Problem first = draw(chain, seed);
        const Problem second = draw(chain, seed);
        EXPECT_EQ(first.start, second.start);
        EXPECT_EQ(first.goal, second.goal);
        EXPECT_EQ(first.obstacles, second.obstacles);
        EXPECT_NE(first.start, draw(chain, seed + 1000).start);
    });
}

TEST_P(Families, OrientationIsTheOneAskedFor) {
    for_each_problem(2, [&](ChainOptions chain, std::uint64_t seed) {
        for (const int sign : {-1, 1}) {
            chain.orientation = sign > 0 ? Orientation::counter_clockwise : Orientation::clockwise;
            const Problem problem = draw(chain, seed);
            EXPECT_EQ(geometry::convex_orientation(problem.start), sign);
            EXPECT_EQ(geometry::convex_orientation(problem.goal), sign);
        }
    });
}

TEST_P(Families, OrientationIsDrawnForBothEndsAlike) {
    std::set<int> seen;
    ChainOptions chain;
    chain.asv_count = GetParam().asv_counts.front();
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        const Problem problem = draw(chain, seed);
        const int start = geometry::convex_orientation(problem.start);
        EXPECT_EQ(start, geometry::convex_orientation(problem.goal)) << "seed " << seed;
        seen.insert(start);
    }
    EXPECT_EQ(seen, (std::set<int>{-1, 1}));
}

TEST_P(Families, ObstaclesAreProperBoxesInTheField) {
    for_each_problem(3, [&](const ChainOptions& chain, std::uint64_t seed) {
        for (const Box& box : draw(chain, seed).obstacles) {
            ASSERT_LT(box.low.x, box.high.x);
            ASSERT_LT(box.low.y, box.high.y);
            ASSERT_GE(std::min(box.low.x, box.low.y), 0);
            ASSERT_LE(std::max(box.high.x, box.high.y), 1);
        }
    });
}

TEST(RandomTurns, AreValidForEveryNumberOfAsvs) {
    const Requirements requirements;
    Rng rng(5);
    for (const std::size_t n : {3u, 4u, 6u, 9u, 15u, 25u, 50u, 100u, 200u}) {
        ChainOptions options;
        options.asv_count = n;
        for (int i = 0; i < 50; ++i) {
            const auto turns = random_turns(options, requirements, rng);
            ASSERT_EQ(turns.size(), n - 2);
            const auto chain = chain_positions(turns, 1, {3, 4}, requirements.broom_length);
            EXPECT_EQ(geometry::convex_orientation(chain), 1) << n;
            EXPECT_GE(geometry::signed_area(chain),
                      (1 + options.area_margin) * requirements.min_area(n) * (1 - 1e-9));
            EXPECT_GE(*std::min_element(turns.begin(), turns.end()), options.min_turn);
        }
    }
}

}  // namespace
}  // namespace asv::core
