#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "io/map/map_file.hpp"
#include "io/map/ros_map.hpp"
#include "io/problem/problem_file.hpp"
#include "io/problem/scenario_file.hpp"
#include "io/solution/solution_file.hpp"
#include "io/text/atomic_file.hpp"
#include "io/text/parse_error.hpp"
#include "tests/kit/files/mutated.hpp"
#include "tests/kit/files/random_files.hpp"
#include "tests/kit/files/temporary_folder.hpp"
#include "tests/kit/scaled.hpp"

namespace asv::io {
namespace {

bool all_finite(std::span<const geometry::Point> points) {
    return std::all_of(points.begin(), points.end(), [](const geometry::Point& point) {
        return std::isfinite(point.x) && std::isfinite(point.y);
    });
}

/// Calls check(text) on broken variants of the file; it returns whether the text was understood.
/// Whatever else it throws fails the test.
template <typename Check>
void try_variants_of(const std::filesystem::path& file, std::uint64_t seed, const Check& check) {
    const std::string original = read_file(file);
    std::size_t understood = 0;
    const std::size_t tries = test::scaled(20'000);
    test::Random random(seed);
    for (std::size_t i = 0; i < tries; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", variant " + std::to_string(i));
        const std::string text = test::mutated(original, random);
        try {
            check(text);
            ++understood;
        } catch (const ParseError& error) {
            ASSERT_GE(error.line(), 1U);
            ASSERT_LE(error.line(), 1U + static_cast<std::size_t>(std::count_if(
                                             text.begin(), text.end(),
                                             [](char c) { return c == '\n' || c == '\r'; })));
            ASSERT_GE(error.column(), 1U);
            ASSERT_LE(error.column(), text.size() + 1);
        }
    }
    EXPECT_GT(understood, 0U);
    EXPECT_LT(understood, tries);
}

TEST(Mutation, ABrokenProblemIsUnderstoodOrRefused) {
    const test::TemporaryFolder folder;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        test::Random random(seed);
        core::Problem problem = test::random_problem(random);
        problem.obstacles.resize(3);
        write_problem(folder / "p", problem);
        try_variants_of(folder / "p", seed, [](const std::string& text) {
            const core::Problem read = parse_problem(text, "p").problem;
            ASSERT_GE(read.asv_count(), 1U);
            ASSERT_EQ(read.goal.size(), read.asv_count());
            ASSERT_TRUE(all_finite(read.start));
            ASSERT_TRUE(all_finite(read.goal));
            for (const geometry::Box& box : read.obstacles) {
                ASSERT_FALSE(geometry::is_empty(box));
                ASSERT_TRUE(all_finite(std::array{box.low, box.high}));
            }
        });
    }
}

TEST(Mutation, ABrokenSolutionIsUnderstoodOrRefused) {
    const test::TemporaryFolder folder;
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        test::Random random(seed);
        write_solution(folder / "s", test::random_solution(random, 3));
        try_variants_of(folder / "s", seed, [](const std::string& text) {
            const core::Solution read = parse_solution(text, 3, "s");
            ASSERT_GE(read.path.size(), 1U);
            ASSERT_TRUE(std::isfinite(read.cost));
            ASSERT_TRUE(all_finite(read.path.points()));
        });
    }
}

TEST(Mutation, ABrokenScenarioIsUnderstoodOrRefused) {
    std::uint64_t seed = 1;
    for (const char* name : {"arm-3-plane", "arm-10-workshop", "point-town"}) {
        const std::string folder = ASV_SOURCE_DIR "/testcases/bodies/";
        // Without its map, which would be read each time.
        const test::TemporaryFolder empty;
        std::string text = read_file(folder + name + ".json");
        const std::size_t map = text.find(" \"map\"");
        if (map != std::string::npos) text.erase(map, text.find('\n', map) - map + 1);
        write_file(empty / "s", text);
        try_variants_of(empty / "s", seed++, [&](const std::string& variant) {
            const core::Problem read = parse_scenario(variant, "s", empty.path()).problem;
            ASSERT_EQ(read.goal.size(), read.start.size());
            ASSERT_TRUE(all_finite(read.start));
            ASSERT_TRUE(all_finite(read.goal));
        });
    }
}

TEST(Mutation, ABrokenMapIsUnderstoodOrRefused) {
    const test::TemporaryFolder folder;
    const std::string maps[] = {"height 3\nwidth 4\n0 1 0 1\n0000\n1111\n",
                                "P2 # c\n4 3\n255\n0 1 2 3 4 5 6 7 8 9 10 255\n",
                                "P5 4 3 255\nabcdefghijkl"};
    std::uint64_t seed = 1;
    for (const std::string& map : maps) {
        write_file(folder / "m", map);
        try_variants_of(folder / "m", seed++, [](const std::string& text) {
            const geometry::Grid grid = parse_map(text, "m");
            ASSERT_EQ(grid.cells.size(), grid.width * grid.height);
        });
    }
}

TEST(Mutation, ABrokenMapOfRosIsUnderstoodOrRefused) {
    const test::TemporaryFolder folder;
    write_file(folder / "m",
               "image: a.png\nresolution: 0.05\norigin: [-10, 5.5, 0]\nnegate: 0 # no\n"
               "occupied_thresh: 0.65\nfree_thresh: 0.25\n");
    try_variants_of(folder / "m", 1, [](const std::string& text) {
        const RosMap map = parse_ros_map(text, "m");
        ASSERT_FALSE(map.image.empty());
        ASSERT_GT(map.resolution, 0);
        ASSERT_LE(map.free_thresh, map.occupied_thresh);
    });
}

}  // namespace
}  // namespace asv::io
