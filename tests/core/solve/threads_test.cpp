#include <chrono>
#include <stop_token>
#include <string_view>
#include <thread>

#include "core/solve/solve.hpp"
#include "tests/kit/chains/problems.hpp"
#include "tests/kit/solving.hpp"

namespace asv::core {
namespace {

using test::expect_solved;
using test::plain;
using test::testcase;

SolveOptions on_four_threads(std::uint64_t seed) {
    SolveOptions options = plain(seed);
    options.threads = 4;
    return options;
}

TEST(SolveThreads, EveryPlannerRaces) {
    const Problem problem = testcase("3ASV.txt");
    for (const std::string_view name : planner_names()) {
        SCOPED_TRACE(name);
        SolveOptions options = on_four_threads(1);
        options.planner = planner_named(name);
        expect_solved(problem, solve(problem, options));
    }
}

TEST(SolveThreads, EveryBodyRaces) {
    for (const char* file : {"7ASV-x6.txt", "bodies/arm-3-plane.json", "bodies/point-town.json"}) {
        SCOPED_TRACE(file);
        const Problem problem = testcase(file);
        expect_solved(problem, solve(problem, on_four_threads(1)));
    }
}

TEST(SolveThreads, TheyImproveTogetherWhileSomebodyWatches) {
    for (const char* file : {"7ASV-x6.txt", "bodies/arm-3-plane.json"}) {
        SCOPED_TRACE(file);
        const Problem problem = testcase(file);
        SolveOptions options = on_four_threads(1);
        options.optimize = 0.5;
        options.keep_trees = true;
        // Not guarded: the documents promise that one thread alone calls it.
        double last = 0;
        options.on_progress = [&last](const SolveProgress& look) { last = look.elapsed; };
        expect_solved(problem, solve(problem, options));
        EXPECT_GE(last, 0);
    }
}

TEST(SolveThreads, AStopFromAnotherThreadEndsThem) {
    const Problem problem = testcase("3ASV-clutter-20.txt");
    std::stop_source source;
    SolveOptions options = on_four_threads(1);
    options.stop = source.get_token();
    options.optimize = 50;
    std::jthread other([&source] {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        source.request_stop();
    });
    const SolveResult result = solve(problem, options);
    EXPECT_LT(result.statistics.time_total, 20);
}

}  // namespace
}  // namespace asv::core
