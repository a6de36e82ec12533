#include "core/generate/vouch/vouch.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/chain/chain.hpp"
#include "core/generate/families.hpp"
#include "core/validation/validate.hpp"
#include "tests/kit/chains/chains.hpp"

namespace asv::core {
namespace {

std::vector<Point> positions(const Chain& chain, const std::vector<double>& row, bool reversed) {
    Pose pose = chain.make_pose();
    chain.forward(row, pose);
    std::vector<Point> points(chain.asv_count());
    copy_positions(pose, points);
    if (reversed) std::reverse(points.begin(), points.end());
    return points;
}

/// The way points lead from start to goal, and states on the straight motions between them meet
/// every requirement: checked by the validator, which shares no code with the proofs.
void expect_witnessed(const Problem& problem, const Verdict& verdict, double step) {
    ASSERT_TRUE(verdict.solvable) << verdict.reason;
    const Chain chain(problem.asv_count(), problem.requirements.broom_length, Anchor::centroid);
    const auto at = [&](const std::vector<double>& row) {
        return positions(chain, row, verdict.reversed);
    };
    const auto& rows = verdict.way_points;
    ASSERT_FALSE(rows.empty());
    EXPECT_LT(test::farthest_move(at(rows.front()), problem.start), 1e-9);
    EXPECT_LT(test::farthest_move(at(rows.back()), problem.goal), 1e-9);
    for (std::size_t i = 0; i + 1 < rows.size(); ++i) {
        double length = 0;
        for (std::size_t k = 0; k < rows[i].size(); ++k)
            length = std::max(length, std::abs(rows[i + 1][k] - rows[i][k]));
        const int pieces = 1 + static_cast<int>(length / step);
        for (int piece = 0; piece < pieces; ++piece) {
            std::vector<double> row = rows[i];
            for (std::size_t k = 0; k < row.size(); ++k)
                row[k] += (rows[i + 1][k] - rows[i][k]) * piece / pieces;
            const auto report = validate_state(problem, at(row), {.tolerance = 1e-9});
            for (const CheckResult& check : report.checks)
                ASSERT_TRUE(check.ok()) << "way point " << i << ": " << describe(check);
        }
    }
}

template <class Options>
Problem draw(Problem (*family)(const Options&, Rng&), Options options, std::size_t n,
             std::uint64_t seed) {
    options.chain.asv_count = n;
    Rng rng(seed);
    return family(options, rng);
}

TEST(Vouch, ThreadsStraightCorridorsAtOnePercentAboveTheLeastHeight) {
    for (std::size_t n = 4; n <= 10; ++n) {
        SCOPED_TRACE("n " + std::to_string(n));
        CorridorOptions options;
        options.height.factor = 1.01;
        const Problem problem = draw(corridor, options, n, n);
        expect_witnessed(problem, vouch(problem), 0.02);
    }
}

TEST(Vouch, FindsWaysInEveryFamilyThatHasEasyOnes) {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const std::vector<Problem> problems{draw(corridor, CorridorOptions{}, 15, seed),
                                            draw(gauntlet, GauntletOptions{}, 7, seed),
                                            draw(rooms, RoomsOptions{}, 7, seed),
                                            draw(maze, MazeOptions{}, 5, seed),
                                            draw(spiral, SpiralOptions{}, 5, seed),
                                            draw(crossing, CrossingOptions{}, 20, seed),
                                            draw(clutter, ClutterOptions{}, 3, seed)};
        for (std::size_t i = 0; i < problems.size(); ++i) {
            SCOPED_TRACE("problem " + std::to_string(i));
            expect_witnessed(problems[i], vouch(problems[i]), 0.05);
        }
    }
}

TEST(Vouch, NeverVouchesForWhatCannotBe) {
    // A corridor lower than the flat chain that is longer than the chain, and a closed door.
    CorridorOptions low;
    low.height.factor = 0.99;
    Problem closed = draw(corridor, CorridorOptions{}, 7, 2);
    closed.obstacles.push_back({{0.45, 0.2}, {0.55, 0.8}});
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        for (const std::size_t n : {3u, 5u, 8u, 10u})
            EXPECT_FALSE(vouch(draw(corridor, low, n, seed)).solvable);
    }
    const Verdict verdict = vouch(closed);
    EXPECT_FALSE(verdict.solvable);
    EXPECT_FALSE(verdict.reason.empty());
    EXPECT_TRUE(verdict.way_points.empty());
}

TEST(Vouch, StraightMotionIsEnoughInAnEmptyField) {
    Problem problem = draw(crossing, CrossingOptions{}, 5, 1);
    problem.obstacles.clear();
    problem.goal = problem.start;
    for (Point& point : problem.goal) point.x += 0.01;
    const Verdict verdict = vouch(problem);
    EXPECT_EQ(verdict.way_points.size(), 2u);
    expect_witnessed(problem, verdict, 0.05);
}

}  // namespace
}  // namespace asv::core
