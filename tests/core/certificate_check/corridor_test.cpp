#include <cmath>

#include <gtest/gtest.h>

#include "core/bounds/certify/certify.hpp"
#include "core/bounds/corridors/area_between_walls.hpp"
#include "core/certificate_check/strip_area.hpp"
#include "core/generate/families.hpp"
#include "core/shapes/flat_chain.hpp"
#include "tests/core/certificate_check/certificate_kit.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/random.hpp"
#include "tests/kit/scaled.hpp"

namespace asv::core {
namespace {

using test::check;
using test::corridor;
using test::corridor_proof;
using test::failures;

/// A corridor of a share of min_flat_height between two blocks, obstacles 1 and 2.
Problem corridor_of(std::size_t asv_count, double share) {
    CorridorOptions options;
    options.chain.asv_count = asv_count;
    options.height.factor = share;
    options.length = 0.05 * static_cast<double>(asv_count) + 0.01;
    Rng rng(1);
    return asv::core::corridor(options, rng);
}

constexpr FacingWalls lower_border{{std::nullopt, 0}, false};
constexpr FacingWalls between{{0, 1}, false};
constexpr FacingWalls upper_border{{1, std::nullopt}, false};

CorridorProof three_corridors(const Problem& problem) {
    return corridor_proof(problem, {corridor(problem, lower_border), corridor(problem, between),
                                    corridor(problem, upper_border)});
}

TEST(CorridorCertificate, IsAcceptedUpToWhatIsProven) {
    for (const std::size_t n : {3u, 4u, 5u, 7u, 10u}) {
        const Problem low = corridor_of(n, n == 3 ? 0.97 : 0.985);
        for (const Problem& problem : {low, test::mirrored(low), test::transposed(low)}) {
            const auto proof = certify_infeasibility(problem);
            ASSERT_TRUE(proof) << n << " ASVs";
            EXPECT_EQ(failures(check(*proof, problem)), "") << n << " ASVs";
        }
    }
}

TEST(CorridorCertificate, IsRefusedWhereTheChainHasRoom) {
    for (const std::size_t n : {3u, 5u, 7u}) {
        for (const double share : {1.0, 1.001, 1.2}) {
            const Problem problem = corridor_of(n, share);
            EXPECT_FALSE(certify_infeasibility(problem));
            EXPECT_EQ(failures(check(three_corridors(problem), problem)),
                      "corridor 2, separation of the middle");
        }
    }
}

TEST(CorridorCertificate, NeedsEveryCorridor) {
    const Problem problem = corridor_of(7, 0.95);
    for (std::size_t i = 0; i < 3; ++i) {
        CorridorProof proof = three_corridors(problem);
        proof.corridors.erase(proof.corridors.begin() + static_cast<std::ptrdiff_t>(i));
        EXPECT_EQ(failures(check(proof, problem)), "separation of the middle");
    }
    CorridorProof proof = three_corridors(problem);
    proof.obstacles.pop_back();
    EXPECT_EQ(failures(check(proof, problem)), "separation of the middle");
    proof.obstacles.push_back(7);
    EXPECT_EQ(failures(check(proof, problem)), "list of obstacles");
}

TEST(CorridorCertificate, HasNumbersThatAreChecked) {
    const Problem problem = corridor_of(7, 0.95);
    const auto expect_failure = [&](auto change, const char* claim) {
        CorridorProof proof = three_corridors(problem);
        change(proof);
        EXPECT_EQ(failures(check(proof, problem)), claim);
    };
    constexpr double off = 1e-8;
    expect_failure([](CorridorProof& is) { is.shrink += off; }, "shrink");
    expect_failure([](CorridorProof& is) { is.required_area -= off; }, "required area");
    expect_failure([](CorridorProof& is) { is.corridors[1].from -= off; }, "corridor 2, from");
    expect_failure([](CorridorProof& is) { is.corridors[1].to += off; }, "corridor 2, to");
    expect_failure([](CorridorProof& is) { is.corridors[1].height += off; }, "corridor 2, height");
    expect_failure([](CorridorProof& is) { is.corridors[1].greatest_area += off; },
                   "corridor 2, area");
    expect_failure([](CorridorProof& is) { is.corridors[1].greatest_area *= 1 - 2e-6; },
                   "corridor 2, area");
}

TEST(CorridorCertificate, IsRefusedWhereTheCorridorIsShorterThanTheChain) {
    Problem problem = corridor_of(7, 0.9);
    for (Box& box : problem.obstacles) box.high.x = box.low.x + 0.3;
    const CertificateVerdict verdict = check(three_corridors(problem), problem);
    EXPECT_FALSE(verdict.accepted());
    for (const CheckedClaim& claim : verdict.claims)
        if (claim.claim == "corridor 2") {
            EXPECT_EQ(claim.detail, "obstacles 1 and 2: too short");
        }
}

TEST(CorridorCertificate, NeedsWallsThatFaceEachOther) {
    const Problem problem = corridor_of(7, 0.95);
    const auto expect_refused = [&](const Problem& given, const FacingWalls& walls) {
        CorridorProof proof = three_corridors(problem);
        proof.corridors[1].between = walls;
        const CertificateVerdict verdict = check(proof, given);
        EXPECT_FALSE(verdict.accepted());
        EXPECT_NE(failures(verdict).find("corridor 2"), std::string::npos);
    };
    expect_refused(problem, {{1, 0}, false});
    expect_refused(problem, {{0, 1}, true});
    expect_refused(problem, {{0, 2}, false});
    expect_refused(problem, {{std::nullopt, std::nullopt}, false});
    Problem apart = problem;
    apart.obstacles[1].low.x = apart.obstacles[0].high.x + 0.01;
    apart.obstacles[1].high.x = apart.obstacles[1].low.x + 0.1;
    expect_refused(apart, between);
    Problem open = problem;
    open.requirements.bounds = without_bounds();
    EXPECT_EQ(failures(check(three_corridors(problem), open)),
              "corridor 1, corridor 3, separation of the middle");
}

TEST(CorridorCertificate, NeedsWallsThickerThanAStep) {
    Problem problem = corridor_of(7, 1.5);
    const Box below = problem.obstacles[0], above = problem.obstacles[1];
    const double middle = (below.high.y + above.low.y) / 2;
    for (const double thickness : {0.00105, 0.00102}) {
        problem.obstacles.resize(2);
        problem.obstacles.push_back(
            {{below.low.x, middle - thickness / 2}, {below.high.x, middle + thickness / 2}});
        const CorridorProof proof = corridor_proof(
            problem, {corridor(problem, lower_border), corridor(problem, {{0, 2}, false}),
                      corridor(problem, {{2, 1}, false}), corridor(problem, upper_border)});
        EXPECT_EQ(check(proof, problem).accepted(), thickness > 0.00103) << thickness;
    }
}

TEST(CorridorCertificate, IsOfChainsOfThreeOrMore) {
    Problem problem = corridor_of(7, 0.95);
    problem.start.resize(2);
    problem.goal.resize(2);
    EXPECT_EQ(failures(check(CorridorProof{}, problem)), "start and goal, body");
    problem.start.resize(1);
    problem.goal.resize(1);
    problem.body = PointBody{};
    EXPECT_EQ(failures(check(CorridorProof{}, problem)), "body");
}

TEST(StripArea, IsTheProversBoundWhereBothTakeAsManyRows) {
    using certificate_check::exact;
    test::Random random(5);
    for (std::size_t i = 0; i < test::scaled(15); ++i) {
        const std::size_t n = 2 + random.below(i % 10 == 0 ? 130 : 15);
        const double height = random.uniform(0, i % 3 == 0 ? 0.2 : 0.05);
        const double found = certificate_check::rounded(certificate_check::strip_area_at_most(
            n, exact(0.05), exact(height), certificate_check::rows_of_statements));
        const double known = max_area_between_walls(n, 0.05, height, true);
        EXPECT_NEAR(found, known, 1e-7 * known) << n << " ASVs, " << height;
    }
    EXPECT_EQ(certificate_check::strip_area_at_most(7, exact(0.05), exact(-1), 16), 0);
}

TEST(StripArea, IsNeverBelowThatOfAChain) {
    using certificate_check::exact;
    test::Random random(6);
    for (std::size_t i = 0; i < test::scaled(100); ++i) {
        const std::size_t n = 3 + random.below(8);
        const double height = random.uniform(0.001, 0.06);
        std::vector<double> y(n);
        for (double& one : y) one = random.uniform(0, height);
        if (i % 2 == 0)
            for (std::size_t k = 0; k < n; ++k) y[k] = k == 0 || k + 1 == n ? 0 : height;
        // The area is greatest where each broom goes ahead while the ends' mean height is above it.
        double area = 0;
        for (std::size_t k = 0; k + 1 < n; ++k) {
            const double climb = y[k + 1] - y[k], above = y[k] + y[k + 1] - y[0] - y[n - 1];
            if (std::abs(climb) > 0.05) area = -1e9;
            area += std::abs(above) / 2 * std::sqrt(std::max(0.0, 0.0025 - climb * climb));
        }
        for (const std::size_t rows : {8u, 32u})
            EXPECT_GE(certificate_check::rounded(certificate_check::strip_area_at_most(
                          n, exact(0.05), exact(height), rows)),
                      area);
    }
}

}  // namespace
}  // namespace asv::core
