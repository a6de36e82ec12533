#include <algorithm>
#include <numbers>

#include <gtest/gtest.h>

#include "core/bounds/certify/certify.hpp"
#include "tests/core/certificate_check/certificate_kit.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/chains/wall_of_two.hpp"

namespace asv::core {
namespace {

using test::check;
using test::failures;

/// Seven ASVs that would have to turn over.
Problem turned_over() {
    Problem problem = test::wall_of_two(7, 0.9);
    std::ranges::reverse(problem.goal);
    return problem;
}

/// Seven ASVs that would need slightly more or less than half a circle.
Problem needs_half_circle(double share) {
    Problem problem = test::wall_of_two(7, 0.9);
    problem.requirements.area_radius_per_broom =
        share * 0.3 / std::numbers::pi / std::numbers::sqrt2 / 6;
    return problem;
}

AreaProof area_proof(const Problem& problem) {
    const Requirements& r = problem.requirements;
    const double length = 6 * (r.broom_length + r.tolerance);
    return {length, length * length / (2 * std::numbers::pi), r.min_area(7) - r.tolerance};
}

TEST(AreaCertificate, OfTwoAsvsIsAccepted) {
    Problem problem;
    problem.start = {{0.1, 0.1}, {0.15, 0.1}};
    problem.goal = {{0.1, 0.2}, {0.15, 0.2}};
    const auto proof = certify_infeasibility(problem);
    ASSERT_TRUE(proof);
    EXPECT_EQ(failures(check(*proof, problem)), "");
    EXPECT_TRUE(check(*proof, problem).accepted());
}

TEST(AreaCertificate, HoldsBeyondHalfACircleAlone) {
    EXPECT_EQ(failures(check(area_proof(needs_half_circle(1.01)), needs_half_circle(1.01))), "");
    EXPECT_EQ(failures(check(area_proof(needs_half_circle(1)), needs_half_circle(1))),
              "too little area");
}

TEST(AreaCertificate, NamesTheNumberThatIsWrong) {
    const Problem problem = needs_half_circle(1.01);
    for (const double factor : {1 + 1e-7, 1 - 1e-7, -1.0, 1e6}) {
        AreaProof proof = area_proof(problem);
        proof.chain_length *= factor;
        EXPECT_EQ(failures(check(proof, problem)), "chain length");
        proof = area_proof(problem);
        proof.greatest_area *= factor;
        EXPECT_EQ(failures(check(proof, problem)), "greatest area");
        proof = area_proof(problem);
        proof.required_area *= factor;
        EXPECT_EQ(failures(check(proof, problem)), "required area");
    }
}

TEST(OrientationCertificate, IsAccepted) {
    for (const Problem& problem : {turned_over(), test::mirrored(turned_over())}) {
        const auto proof = certify_infeasibility(problem);
        ASSERT_TRUE(proof);
        EXPECT_EQ(failures(check(*proof, problem)), "");
    }
}

TEST(OrientationCertificate, IsNotAcceptedForOneDirection) {
    Problem problem = turned_over();
    auto proof = std::get<OrientationProof>(certify_infeasibility(problem).value());
    std::ranges::reverse(problem.goal);
    proof.goal_area = -proof.goal_area;
    EXPECT_EQ(failures(check(proof, problem)), "opposite");
}

TEST(OrientationCertificate, IsNotAcceptedWhereAStepMayTurnTheChainOver) {
    Problem problem = turned_over();
    auto proof = std::get<OrientationProof>(certify_infeasibility(problem).value());
    const double chain = 6 * (problem.requirements.broom_length + problem.requirements.tolerance);
    problem.requirements.max_step = 0.05;
    proof.greatest_change = 2 * chain * (0.05 + problem.requirements.tolerance);
    EXPECT_EQ(failures(check(proof, problem)), "no step turns over");
}

TEST(OrientationCertificate, NeedsAValidStartAndGoal) {
    const Problem problem = turned_over();
    const auto proof = std::get<OrientationProof>(certify_infeasibility(problem).value());
    for (const bool goal : {false, true}) {
        Problem flat = problem;
        std::vector<Point>& state = goal ? flat.goal : flat.start;
        for (std::size_t i = 0; i < state.size(); ++i)
            state[i] = {0.05 + 0.05 * static_cast<double>(i), 0.9 - (i == 3 ? 1e-6 : 0)};
        const CertificateVerdict verdict = check(proof, flat);
        EXPECT_NE(failures(verdict).find("start and goal"), std::string::npos);
        EXPECT_NE(failures(verdict).find("no step turns over"), std::string::npos);
    }
}

TEST(AreaCertificates, AreForChainsAlone) {
    Problem point;
    point.start = {{0.1, 0.1}};
    point.goal = {{0.9, 0.1}};
    point.body = PointBody{};
    EXPECT_EQ(failures(check(AreaProof{}, point)), "body");
    EXPECT_EQ(failures(check(OrientationProof{}, point)), "body");
}

TEST(Certificates, AreAboutOneProblem) {
    const Problem problem = turned_over();
    const Certificate good{certified(problem, "abc"), certify_infeasibility(problem).value()};
    EXPECT_TRUE(check_certificate(good, problem, "abc").accepted());
    EXPECT_EQ(failures(check_certificate(good, problem, "abd")), "digest");
    const auto expect_failure = [&](auto change, const char* claim) {
        Certificate changed = good;
        change(changed.problem);
        EXPECT_EQ(failures(check_certificate(changed, problem, "abc")), claim);
    };
    expect_failure([](CertifiedProblem& is) { is.asv_count = 8; }, "ASVs");
    expect_failure([](CertifiedProblem& is) { is.obstacle_count = 1; }, "obstacles");
    expect_failure([](CertifiedProblem& is) { is.broom_length = 0.051; }, "broom length");
    expect_failure([](CertifiedProblem& is) { is.max_step = 0.0011; }, "greatest step");
    expect_failure([](CertifiedProblem& is) { is.tolerance = 1.1e-5; }, "tolerance");
}

}  // namespace
}  // namespace asv::core
