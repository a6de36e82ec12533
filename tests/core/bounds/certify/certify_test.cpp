#include "core/bounds/certify/certify.hpp"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "core/bounds/certify/needed.hpp"
#include "core/bounds/feasibility.hpp"
#include "core/certificate_check/check_certificate.hpp"
#include "core/validation/validate.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/chains/wall_of_two.hpp"
#include "tests/kit/random.hpp"
#include "tests/kit/scaled.hpp"

namespace asv::core {
namespace {

std::string failures(const InfeasibilityProof& proof, const Problem& problem) {
    std::string names;
    for (const CheckedClaim& claim :
         check_certificate({certified(problem, ""), proof}, problem, "").claims)
        if (!claim.holds) names += claim.claim + ": " + claim.detail + "; ";
    return names;
}

TEST(Needed, IsWhatCannotBeDropped) {
    std::vector<int> things(100);
    std::iota(things.begin(), things.end(), 0);
    const auto has = [](const std::vector<int>& some, int thing) {
        return std::ranges::find(some, thing) != some.end();
    };
    const auto suffices = [&](const std::vector<int>& some) {
        return has(some, 3) && has(some, 50) && (has(some, 98) || has(some, 20));
    };
    EXPECT_EQ(needed(things, suffices, 100'000), (std::vector<int>{3, 20, 50}));
    EXPECT_EQ(needed(things, suffices, 99), things) << "nothing may be tried";
    EXPECT_TRUE(suffices(needed(things, suffices, 500)));
    EXPECT_TRUE(needed(std::vector<int>{}, suffices, 100).empty());
}

TEST(Certify, FindsNothingWhereNothingIsProven) {
    EXPECT_FALSE(certify_infeasibility(test::wall_of_two(3, 0.9)));
    EXPECT_FALSE(certify_infeasibility(test::wall_of_two(7, 1))) << "as intended alone";
}

TEST(Certify, NamesFewOfManyObstacles) {
    Problem problem = test::wall_of_two(7, 1);
    Rng rng(1);
    problem.obstacles = test::clutter(rng, 500, 0.02, problem);
    problem.obstacles.insert(problem.obstacles.begin() + 250, Box{{0.5, -0.1}, {0.55, 1.1}});
    const auto proof = certify_infeasibility(problem);
    ASSERT_TRUE(proof);
    EXPECT_EQ(std::get<SeparationProof>(*proof).obstacles, std::vector<std::size_t>{250});
}

TEST(Certify, GivesUpWhereNobodyWouldCheckIt) {
    Problem problem = test::wall_of_two(3, 1);
    problem.obstacles.clear();
    // A wall of slices that overlap, all of which are needed.
    const std::size_t slices = most_certified_obstacles + 10;
    const double height = 1.001 / static_cast<double>(slices);
    for (std::size_t i = 0; i < slices; ++i) {
        const double low = -0.0005 + height * static_cast<double>(i);
        problem.obstacles.push_back({{0.5, low - 0.0006}, {0.6, low + height + 0.0006}});
    }
    ASSERT_EQ(check_feasibility(problem).cause, Infeasibility::separated);
    EXPECT_FALSE(certify_infeasibility(problem));
}

/// A wall of boxes across the square, or two of them, that overlap or touch or leave gaps.
Problem random_wall(test::Random& random) {
    Problem problem = test::wall_of_two(3 + random.below(6), 1);
    problem.obstacles.clear();
    const double thickness = random.uniform(0.001, 0.1);
    double low = random.one_in(2) ? 0 : -0.01;
    while (low < 1) {
        const double high = low + random.uniform(0.01, 0.6);
        problem.obstacles.push_back({{0.5, low}, {0.5 + thickness, std::min(high, 1.0)}});
        constexpr double gaps[] = {0, 1e-6, 9e-6, -1e-5, -1e-3, -0.01, 0.003, 0.015};
        low = high + gaps[random.below(std::size(gaps))];
    }
    if (random.one_in(2)) problem = test::transposed(problem);
    if (random.one_in(3)) problem = test::mirrored(problem);
    return problem;
}

TEST(Certify, WhateverIsProvenIsAccepted) {
    test::Random random(1);
    std::size_t proven = 0, with_seams = 0;
    for (std::size_t i = 0; i < test::scaled(300); ++i) {
        const Problem problem = random_wall(random);
        if (!validate_state(problem, problem.start).valid()) continue;
        if (!validate_state(problem, problem.goal).valid()) continue;
        const auto proof = certify_infeasibility(problem);
        const bool known = check_area(problem).proven_infeasible() ||
                           check_orientation(problem).proven_infeasible() ||
                           check_separation(problem).proven_infeasible();
        EXPECT_EQ(proof.has_value(), known) << "wall " << i;
        if (!proof) continue;
        EXPECT_EQ(failures(*proof, problem), "") << "wall " << i;
        ++proven;
        const auto* separation = std::get_if<SeparationProof>(&*proof);
        with_seams += separation != nullptr && !separation->seams.empty();
    }
    if (test::scaled(300) < 300) return;
    EXPECT_GT(proven, 15u);
    EXPECT_GT(with_seams, 5u);
}

TEST(Certify, HoldsInOtherUnitsAndWithoutBounds) {
    for (const double unit : {1e-3, 1.0, 1e4}) {
        Problem problem = test::wall_of_two(3, 1);
        problem.obstacles = {{{-0.1, 0}, {0.7, 0.02}},
                             {{-0.1, 0.98}, {0.7, 1}},
                             {{-0.1, 0}, {-0.08, 1}},
                             {{0.5, 0}, {0.6, 1}}};
        for (const bool bounded : {true, false}) {
            Problem scaled = problem;
            const auto scale = [&](Point& point) { point = {point.x * unit, point.y * unit}; };
            for (auto* state : {&scaled.start, &scaled.goal})
                for (Point& point : *state) scale(point);
            for (Box& box : scaled.obstacles) {
                scale(box.low);
                scale(box.high);
            }
            Requirements& r = scaled.requirements;
            r.broom_length *= unit;
            r.max_step *= unit;
            r.area_radius_per_broom *= unit;
            r.tolerance *= std::min(1.0, unit * unit);
            r.bounds = bounded ? Box{{0, 0}, {unit, unit}} : without_bounds();
            const auto proof = certify_infeasibility(scaled);
            ASSERT_TRUE(proof) << unit;
            EXPECT_EQ(failures(*proof, scaled), "") << unit;
        }
    }
}

}  // namespace
}  // namespace asv::core
