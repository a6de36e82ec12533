#include <gtest/gtest.h>

#include "core/bounds/certify/certify.hpp"
#include "core/generate/families.hpp"
#include "tests/core/certificate_check/certificate_kit.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/chains/wall_of_two.hpp"
#include "tests/kit/scaled.hpp"

namespace asv::core {
namespace {

using test::check;
using test::failures;

/// Everything that somebody could say of the problem, each number of it true.
std::vector<InfeasibilityProof> forged(const Problem& problem) {
    std::vector<InfeasibilityProof> proofs;
    std::vector<ClosedSeam> seams;
    for (std::size_t i = 0; i < problem.obstacles.size(); ++i) {
        for (std::size_t j = 0; j < problem.obstacles.size(); ++j)
            if (i != j)
                for (const bool upright : {false, true})
                    seams.push_back(test::seam(problem, {{i, j}, upright}));
    }
    // Where they are no seams, a certificate that names them says so; with true ones alone the
    // rest has to fail.
    std::erase_if(seams, [&](const ClosedSeam& seam) {
        const SeparationProof one{problem.asv_count() / 2, 0.000515, {}, {seam}};
        return failures(check(one, problem)).find("seam") != std::string::npos;
    });
    for (std::size_t asv = 0; asv < problem.asv_count(); ++asv)
        proofs.push_back(SeparationProof{asv, 0.000515, test::all_obstacles(problem)});
    proofs.push_back(
        SeparationProof{problem.asv_count() / 2, 0.000515, test::all_obstacles(problem), seams});
    std::vector<ClosedCorridor> corridors = test::all_corridors(problem);
    proofs.push_back(test::corridor_proof(problem, corridors));
    std::erase_if(corridors, [&](const ClosedCorridor& corridor) {
        return corridor.greatest_area >= test::corridor_proof(problem, {}).required_area;
    });
    proofs.push_back(test::corridor_proof(problem, corridors));
    return proofs;
}

void expect_none_accepted(const Problem& problem, const std::string& name) {
    EXPECT_FALSE(certify_infeasibility(problem)) << name;
    for (const InfeasibilityProof& proof : forged(problem))
        EXPECT_FALSE(check(proof, problem).accepted()) << name;
}

TEST(ForgedCertificates, AreRefusedWhereThereIsAPath) {
    for (const char* name : {"3ASV.txt", "7ASV.txt", "3ASV-maze.txt", "7ASV-x2.txt"})
        expect_none_accepted(test::testcase(name), name);
    expect_none_accepted(test::wall_of_two(7, 1), "a wall that seven ASVs squeeze through");
    expect_none_accepted(test::wall_of_two(3, 0.9), "a wall with a door");
}

TEST(ForgedCertificates, AreRefusedForCorridorsThatAreHighEnough) {
    Rng rng(3);
    for (std::size_t i = 0; i < test::scaled(8); ++i) {
        CorridorOptions options;
        options.chain.asv_count = 3 + rng.below(6);
        options.height.factor = rng.uniform(1, 1.1);
        Rng of_corridor(rng.bits());
        expect_none_accepted(corridor(options, of_corridor), "corridor " + std::to_string(i));
    }
}

TEST(ForgedCertificates, AreRefusedInTheOpen) {
    Rng rng(4);
    for (std::size_t i = 0; i < test::scaled(10); ++i)
        expect_none_accepted(test::cluttered(rng, 3 + rng.below(5), 8, 0.1),
                             "clutter " + std::to_string(i));
}

}  // namespace
}  // namespace asv::core
