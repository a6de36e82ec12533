#include "core/solve/replan.hpp"

#include <filesystem>
#include <limits>
#include <string>

#include "core/model/cost.hpp"
#include "core/validation/validate.hpp"
#include "io/problem/problem_file.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/seeds.hpp"
#include "tests/kit/solving.hpp"

namespace asv::core {
namespace {

using test::expect_solved;
using test::plain;
using test::testcase;

constexpr std::uint64_t the_seed = 1;

Path path_for(const Problem& problem) {
    return solve(problem, plain(the_seed)).solution->path;
}

/// A small box around a point, as one that somebody drags there.
Box box_at(const Point& point) {
    constexpr double half_side = 0.01;
    return {{point.x - half_side, point.y - half_side}, {point.x + half_side, point.y + half_side}};
}

/// How many nodes the search for the first path took is not told where none was needed.
bool from_nothing(const SolveResult& result) {
    return result.statistics.tree_nodes[0] > 0;
}

struct EachBody : ::testing::TestWithParam<const char*> {
    Problem problem() const {
        return io::read_problem(std::filesystem::path(ASV_SOURCE_DIR) / "testcases" / GetParam())
            .problem;
    }
};

TEST_P(EachBody, KeepsAPathThatIsStillValidWithoutASearch) {
    const Problem problem = this->problem();
    const SolveResult again = replan(problem, path_for(problem), plain(the_seed));
    expect_solved(problem, again);
    EXPECT_FALSE(from_nothing(again));
    EXPECT_EQ(again.statistics.iterations, 0U);
}

TEST_P(EachBody, TheSameSeedGivesTheSamePath) {
    const Problem problem = this->problem();
    const Path last = path_for(problem);
    const SolveResult once = replan(problem, last, plain(the_seed));
    const SolveResult twice = replan(problem, last, plain(the_seed));
    ASSERT_TRUE(once.solution && twice.solution);
    EXPECT_TRUE(std::ranges::equal(once.solution->path.points(), twice.solution->path.points()));
}

TEST_P(EachBody, TakesTheOldPathTheOtherWayRound) {
    Problem problem = this->problem();
    SolveOptions options = plain(the_seed);
    options.reverse = true;
    const SolveResult again = replan(problem, path_for(problem), options);
    expect_solved(problem, again);
    EXPECT_FALSE(from_nothing(again));
}

TEST_P(EachBody, CertifiesMotionAndLeavesOutBoundsWithoutAnotherPath) {
    const Problem problem = this->problem();
    const Path last = path_for(problem);
    SolveOptions options = plain(the_seed);
    const SolveResult usual = replan(problem, last, options);
    options.certify_motion = true;
    options.find_bounds = false;
    const SolveResult certified = replan(problem, last, options);
    ASSERT_TRUE(usual.solution && certified.solution);
    EXPECT_TRUE(
        std::ranges::equal(usual.solution->path.points(), certified.solution->path.points()));
    EXPECT_TRUE(usual.report.motion.empty());
    EXPECT_GT(usual.statistics.cost_lower_bound, 0);
    EXPECT_FALSE(certified.report.motion.empty());
    EXPECT_TRUE(certified.report.valid());
    EXPECT_EQ(certified.statistics.cost_lower_bound, 0);
}

INSTANTIATE_TEST_SUITE_P(Bodies, EachBody,
                         ::testing::Values("3ASV.txt", "7ASV.txt", "bodies/arm-3-plane.json",
                                           "bodies/arm-5-workshop.json", "bodies/point-town.json"),
                         [](const auto& given) {
                             std::string label = given.param;
                             std::erase_if(label, [](char c) { return std::isalnum(c) == 0; });
                             return label;
                         });

TEST(Replan, GoesRoundABoxThatIsPutOnThePath) {
    Problem problem = testcase("3ASV-x4.txt");
    const Path last = path_for(problem);
    const std::size_t asv = problem.asv_count() / 2;
    problem.obstacles.push_back(box_at(last.state(last.size() / 2)[asv]));
    ASSERT_TRUE(invalid_ends(problem).empty());
    ASSERT_FALSE(validate(problem, {last, cost(problem, last)}).valid());
    expect_solved(problem, replan(problem, last, plain(the_seed)));
}

TEST(Replan, FollowsEndsThatMove) {
    Problem problem = testcase("3ASV-x4.txt");
    const Path last = path_for(problem);
    const std::size_t later = last.size() / 10;
    const auto start = last.state(later), goal = last.state(last.size() - 1 - later);
    problem.start.assign(start.begin(), start.end());
    problem.goal.assign(goal.begin(), goal.end());
    const SolveResult again = replan(problem, last, plain(the_seed));
    expect_solved(problem, again);
    EXPECT_FALSE(from_nothing(again));
}

TEST(Replan, PlansFromNothingWhereTheLastPathIsOfAnotherNumberOfAsvs) {
    const Problem problem = testcase("3ASV.txt");
    const SolveResult again = replan(problem, path_for(testcase("7ASV.txt")), plain(the_seed));
    expect_solved(problem, again);
    EXPECT_TRUE(from_nothing(again));
    const SolveResult of_none = replan(problem, Path(problem.asv_count()), plain(the_seed));
    expect_solved(problem, of_none);
}

TEST(Replan, AnyPathWillDo) {
    const Problem problem = testcase("3ASV.txt");
    test::for_seeds(10, [&](Rng& rng) {
        Path nonsense(problem.asv_count());
        std::vector<Point> state(problem.asv_count());
        for (int i = 0; i < 100; ++i) {
            for (Point& point : state) point = {rng.uniform(-1, 2), rng.uniform(-1, 2)};
            nonsense.push_back(state);
        }
        expect_solved(problem, replan(problem, nonsense, plain(the_seed)));
        state[0].x = std::numeric_limits<double>::quiet_NaN();
        nonsense.push_back(state);
        expect_solved(problem, replan(problem, nonsense, plain(the_seed)));
    });
}

TEST(Replan, SaysThatEndsAreInvalidAsSolveDoes) {
    Problem problem = testcase("3ASV.txt");
    const Path last = path_for(problem);
    problem.obstacles.push_back(box_at(problem.start[1]));
    EXPECT_THROW(replan(problem, last, plain(the_seed)), InvalidEnds);
}

/// Whose steering is straight may have to start from nothing.
TEST(Replan, EveryPlannerFindsAPath) {
    const Problem problem = testcase("3ASV-x4.txt");
    const Path last = path_for(problem);
    for (const std::string_view name : planner_names()) {
        SCOPED_TRACE(name);
        SolveOptions options = plain(the_seed);
        options.planner = planner_named(name);
        expect_solved(problem, replan(problem, last, options));
    }
}

}  // namespace
}  // namespace asv::core
