#include <algorithm>

#include <gtest/gtest.h>

#include "core/bounds/certify/certify.hpp"
#include "tests/core/certificate_check/certificate_kit.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/chains/wall_of_two.hpp"

namespace asv::core {
namespace {

using test::check;
using test::failures;

/// A wall of one piece across the square, of this thickness.
Problem walled_off(double thickness = 0.1) {
    Problem problem = test::wall_of_two(3, 1);
    problem.obstacles = {{{0.2, 0.9}, {0.3, 0.95}}, {{0.5, -0.1}, {0.5 + thickness, 1.1}}};
    return problem;
}

SeparationProof separation_of(const Problem& problem) {
    return std::get<SeparationProof>(certify_infeasibility(problem).value());
}

TEST(SeparationCertificate, NamesTheObstaclesThatAreNeeded) {
    const Problem problem = walled_off();
    const SeparationProof proof = separation_of(problem);
    EXPECT_EQ(proof.obstacles, std::vector<std::size_t>{1});
    EXPECT_TRUE(proof.seams.empty());
    for (std::size_t asv = 0; asv < 3; ++asv) {
        SeparationProof of_asv = proof;
        of_asv.asv = asv;
        EXPECT_EQ(failures(check(of_asv, problem)), "") << "ASV " << asv;
    }
    SeparationProof all = proof;
    all.obstacles = {0, 1};
    EXPECT_EQ(failures(check(all, problem)), "");
}

TEST(SeparationCertificate, IsRefusedWhenTheWallsLeaveAWay) {
    const Problem problem = walled_off();
    for (const std::vector<std::size_t>& obstacles : {std::vector<std::size_t>{}, {0}}) {
        SeparationProof proof = separation_of(problem);
        proof.obstacles = obstacles;
        EXPECT_EQ(failures(check(proof, problem)), "separation of ASV 1");
    }
    SeparationProof proof = separation_of(problem);
    Problem open = problem;
    open.requirements.bounds = without_bounds();
    EXPECT_EQ(failures(check(proof, open)), "separation of ASV 1") << "around the wall";
    EXPECT_EQ(failures(check(proof, walled_off(0.001))), "separation of ASV 1")
        << "a wall that can be jumped over";
}

TEST(SeparationCertificate, NeedsNoBordersWhereAWallGoesRound) {
    Problem problem = test::wall_of_two(3, 1);
    problem.obstacles = {{{0.01, 0.01}, {0.5, 0.05}},
                         {{0.01, 0.95}, {0.5, 0.99}},
                         {{0.01, 0.01}, {0.05, 0.99}},
                         {{0.5, 0.01}, {0.55, 0.99}}};
    problem.requirements.bounds = without_bounds();
    const auto proof = certify_infeasibility(problem);
    ASSERT_TRUE(proof);
    EXPECT_EQ(std::get<SeparationProof>(*proof).obstacles.size(), 4u);
    EXPECT_EQ(failures(check(*proof, problem)), "");
}

TEST(SeparationCertificate, ListsEachObstacleOnceAndInOrder) {
    const Problem problem = walled_off();
    for (const std::vector<std::size_t>& obstacles :
         {std::vector<std::size_t>{1, 0}, {1, 1}, {1, 2}, {7}}) {
        SeparationProof proof = separation_of(problem);
        proof.obstacles = obstacles;
        EXPECT_EQ(failures(check(proof, problem)), "list of obstacles");
    }
    Problem crowd = problem;
    crowd.obstacles.resize(most_certified_obstacles + 1, {{0.9, 0.9}, {0.91, 0.91}});
    SeparationProof proof = separation_of(problem);
    proof.obstacles = test::all_obstacles(crowd);
    EXPECT_EQ(failures(check(proof, crowd)), "list of obstacles");
}

TEST(SeparationCertificate, HasNumbersThatAreChecked) {
    const Problem problem = walled_off();
    SeparationProof proof = separation_of(problem);
    proof.shrink *= 1.00001;
    EXPECT_EQ(failures(check(proof, problem)), "shrink");
    proof = separation_of(problem);
    proof.asv = 3;
    EXPECT_EQ(failures(check(proof, problem)), "separation");
}

TEST(SeparationCertificate, IsRefusedWhenAnEndIsInAWall) {
    Problem problem = walled_off();
    const SeparationProof proof = separation_of(problem);
    for (auto state : {&Problem::start, &Problem::goal}) {
        Problem stuck = problem;
        for (Point& point : stuck.*state) point.x = 0.55;
        EXPECT_EQ(failures(check(proof, stuck)), "start and goal, separation of ASV 1");
    }
}

TEST(SeparationCertificate, IsOfPointsAndNotOfWhatMeetsNoObstacle) {
    Problem problem = walled_off();
    problem.start = {{0.1, 0.1}};
    problem.goal = {{0.9, 0.1}};
    const SeparationProof proof{0, 0.000515, {1}};
    EXPECT_EQ(failures(check(proof, problem)), "body");
    problem.body = PointBody{};
    EXPECT_EQ(failures(check(proof, problem)), "");
    problem.body = PlanarArm{{0.1}, {JointRange{}}, AngleReference::x_axis, {0}, {0}};
    EXPECT_NE(failures(check(proof, problem)).find("body"), std::string::npos);
}

/// A wall of two boxes that touch each other, and the borders.
SeparationProof proof_with_seam(const Problem& problem, std::size_t asv) {
    return {asv,
            0.000515,
            {0, 1},
            {test::seam(problem, {{0, 1}, false}), test::seam(problem, {{std::nullopt, 0}, false}),
             test::seam(problem, {{1, std::nullopt}, false})}};
}

TEST(SeamCertificate, ClosesTouchingBoxesForShortChains) {
    for (const bool upright : {false, true}) {
        const Problem wall = test::wall_of_two(3, 1);
        const Problem problem = upright ? test::transposed(wall) : wall;
        const SeparationProof proof = separation_of(problem);
        EXPECT_EQ(proof.asv, 1u);
        ASSERT_EQ(proof.seams.size(), 3u);
        EXPECT_EQ(proof.seams[0].between.upright, upright);
        EXPECT_EQ(failures(check(proof, problem)), "");
    }
}

TEST(SeamCertificate, MayBeAtTheBorder) {
    Problem problem = test::wall_of_two(3, 1);
    problem.obstacles = {{{0.5, 0}, {0.6, 0.999995}}};
    const SeparationProof proof = separation_of(problem);
    EXPECT_EQ(proof.seams.size(), 2u);
    EXPECT_EQ(failures(check(proof, problem)), "");
}

TEST(SeamCertificate, IsRefusedWhereAChainSqueezesThrough) {
    const Problem problem = test::wall_of_two(7, 1);
    EXPECT_FALSE(certify_infeasibility(problem));
    EXPECT_EQ(failures(check(proof_with_seam(problem, 3), problem)),
              "seam 1, seam 2, seam 3, separation of ASV 4");
}

TEST(SeamCertificate, SpeaksOfTheMiddleOfTheChain) {
    const Problem problem = test::wall_of_two(3, 1);
    EXPECT_EQ(failures(check(proof_with_seam(problem, 1), problem)), "");
    for (const std::size_t asv : {0u, 2u})
        EXPECT_EQ(failures(check(proof_with_seam(problem, asv), problem)),
                  "seam 1, seam 2, seam 3, separation of ASV " + std::to_string(asv + 1));
    Problem point = problem;
    point.start = {{0.1, 0.1}};
    point.goal = {{0.9, 0.1}};
    point.body = PointBody{};
    EXPECT_EQ(failures(check(proof_with_seam(point, 0), point)),
              "seam 1, seam 2, seam 3, separation of ASV 1");
}

TEST(SeamCertificate, HasNumbersThatAreChecked) {
    const Problem problem = test::wall_of_two(3, 1);
    const auto expect_failure = [&](auto change, const char* claim) {
        SeparationProof proof = proof_with_seam(problem, 1);
        change(proof.seams[0]);
        EXPECT_EQ(failures(check(proof, problem)), claim);
    };
    constexpr double off = 1e-8;
    expect_failure([](ClosedSeam& is) { is.gap.low.x += off; }, "seam 1, gap");
    expect_failure([](ClosedSeam& is) { is.gap.low.y += off; }, "seam 1, gap");
    expect_failure([](ClosedSeam& is) { is.gap.high.x += off; }, "seam 1, gap");
    expect_failure([](ClosedSeam& is) { is.gap.high.y += off; }, "seam 1, gap");
    expect_failure([](ClosedSeam& is) { is.width += off; }, "seam 1, width");
    expect_failure([](ClosedSeam& is) { is.depth -= off; }, "seam 1, depth");
    expect_failure(
        [](ClosedSeam& is) {
            is.between.walls = {1, 0};
        },
        "seam 1, separation of ASV 2");
}

TEST(SeamCertificate, IsRefusedWhereTheGapIsTooWideOrTooShort) {
    Problem problem = test::wall_of_two(3, 1);
    problem.obstacles[0].high.y -= 2e-3;
    EXPECT_EQ(failures(check(proof_with_seam(problem, 1), problem)), "seam 1, separation of ASV 2");
    problem = test::wall_of_two(3, 1);
    for (Box& box : problem.obstacles) box.high.x = box.low.x + 0.005;
    EXPECT_EQ(failures(check(proof_with_seam(problem, 1), problem)),
              "seam 1, seam 2, seam 3, separation of ASV 2");
    problem = test::wall_of_two(3, 1);
    problem.requirements.tolerance = 1e-3;
    SeparationProof proof = proof_with_seam(problem, 1);
    proof.shrink = 2e-3;
    EXPECT_EQ(failures(check(proof, problem)), "seam 1, seam 2, seam 3, separation of ASV 2");
}

TEST(SeamCertificate, IsNothingForTwoAsvs) {
    Problem problem = test::wall_of_two(3, 1);
    problem.start.pop_back();
    problem.goal.pop_back();
    problem.requirements.area_radius_per_broom = 0;
    EXPECT_NE(failures(check(proof_with_seam(problem, 1), problem)).find("seam 1"),
              std::string::npos);
}

}  // namespace
}  // namespace asv::core
