#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <optional>
#include <vector>

#include "core/search/rng.hpp"
#include "core/solve/prepared_world.hpp"
#include "io/problem/problem_file.hpp"

/// Queries per second of one core in one world: prepared, and by solve() for each, by turns in the
/// same session, with their ratio; of medians. A query leads from the start of the problem to the
/// same placement, shifted at random by at most so much along both axes, without improvement and
/// without lower bounds. Usage: asv-benchmark-queries PROBLEM [QUERIES] [LARGEST_SHIFT]

namespace {

using namespace asv::core;
using Clock = std::chrono::steady_clock;

template <class Work>
double seconds(Work&& work) {
    const Clock::time_point begin = Clock::now();
    work();
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// Some queries are far harder than most, and their times say nothing of the preparation.
double median(std::vector<double> times) {
    std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2),
                     times.end());
    return times[times.size() / 2];
}

/// A goal that is valid. Ends of scenarios that are not valid are not asked for.
WorldQuery draw_query(const PreparedWorld& world, double largest_shift, Rng& rng) {
    while (true) {
        WorldQuery query;
        query.goal.points = world.problem().start;
        const double x = rng.uniform(-largest_shift, largest_shift);
        const double y = rng.uniform(-largest_shift, largest_shift);
        for (Point& point : query.goal.points) point = {point.x + x, point.y + y};
        if (invalid_ends(world.problem_of(query)).empty()) return query;
    }
}

void compare(const Problem& problem, int queries, double largest_shift) {
    SolveOptions options;
    options.optimize = 0;
    options.find_bounds = false;
    options.max_iterations = 1000;  // a goal in a pocket is as hard for both
    std::optional<PreparedWorld> world;
    const double preparation = seconds([&] { world.emplace(problem); });
    Rng rng(1);
    std::vector<double> prepared, each;
    for (int i = 0; i < queries; ++i) {
        const WorldQuery query = draw_query(*world, largest_shift, rng);
        const Problem asked = world->problem_of(query);
        options.seed = static_cast<std::uint64_t>(i);
        // Whoever comes second finds the memory warm.
        for (const bool first : {true, false}) {
            if (first == (i % 2 == 0))
                prepared.push_back(seconds([&] { world->solve(query, options); }));
            else
                each.push_back(seconds([&] { solve(asked, options); }));
        }
    }
    std::printf("%zu obstacles, %d queries: prepared in %.2g ms\n", problem.obstacles.size(),
                queries, 1e3 * preparation);
    const double one = median(prepared), other = median(each);
    std::printf("prepared %.4g queries/s, solve() %.4g queries/s, ratio %.3g\n", 1 / one, 1 / other,
                other / one);
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 2) {
        std::fputs("Usage: asv-benchmark-queries PROBLEM [QUERIES] [LARGEST_SHIFT]\n", stderr);
        return 2;
    }
    const int queries = argc > 2 ? std::atoi(argv[2]) : 100;
    const double largest_shift = argc > 3 ? std::atof(argv[3]) : 0.1;
    compare(asv::io::read_problem(argv[1]).problem, queries, largest_shift);
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
