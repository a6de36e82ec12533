#include <algorithm>

#include <gtest/gtest.h>

#include "geometry/predicates/distance.hpp"
#include "io/drawing/scene/scene_outline.hpp"
#include "io/text/atomic_file.hpp"
#include "tests/kit/files/drawing_samples.hpp"

namespace asv::io {
namespace {

using geometry::Segment;
using test::Box;
using test::Point;
using test::sample;
using test::two_walls;

std::vector<const SceneLine*> lines_of(const Scene& scene, Role role) {
    std::vector<const SceneLine*> lines;
    for (const SceneLine& line : scene.lines) {
        if (line.role == role) lines.push_back(&line);
    }
    return lines;
}

TEST(Scene, IsTheGoldenOneForASmallProblem) {
    ExhibitInput input = sample(3, {{0.1, 0.3}, {0.5, 0.3}}, {{{0.3, 0.2}, {0.35, 0.299}}});
    input.trees =
        SearchTrees{"golden",
                    3,
                    {{"start", {{0.1, 0.3}, {0.2, 0.4}}, {-1, 0}}, {"goal", {{0.5, 0.3}}, {-1}}},
                    {}};
    const std::string golden =
        read_file(std::string(ASV_SOURCE_DIR) + "/tests/io/drawing/golden/scene.txt");
    EXPECT_EQ(outline(make_scene(make_exhibit(std::move(input)))), golden);
}

TEST(Scene, ShowsWhatIsThereWithoutASolution) {
    ExhibitInput input = sample(3, {{0.1, 0.3}, {0.2, 0.3}}, two_walls());
    input.solution.reset();
    const Scene scene = make_scene(make_exhibit(std::move(input)));
    EXPECT_EQ(scene.obstacles, two_walls());
    EXPECT_EQ(lines_of(scene, Role::start).size(), 1U);
    EXPECT_EQ(lines_of(scene, Role::goal).size(), 1U);
    EXPECT_EQ(scene.lines.size(), 4U) << "the two chains and their closing sides";
    EXPECT_FALSE(scene.least);
}

TEST(Scene, GhostsAreEvenInDistanceNotInTime) {
    // The second half of the way takes ten times as many steps as the first.
    ExhibitInput input = sample(5, {{0.1, 0.3}, {0.3, 0.3}}, {}, 0.001);
    const ExhibitInput slow = sample(5, {{0.3, 0.3}, {0.5, 0.3}}, {}, 0.0001);
    for (std::size_t i = 1; i < slow.solution->path.size(); ++i) {
        input.solution->path.push_back(slow.solution->path.state(i));
    }
    const Exhibit exhibit = make_exhibit(std::move(input));
    const Scene scene = make_scene(exhibit);
    const auto ghosts = lines_of(scene, Role::ghost);
    ASSERT_EQ(ghosts.size(), scene.ghosts);
    ASSERT_GE(ghosts.size(), 4U);
    const double gap = 0.4 / static_cast<double>(ghosts.size() + 1);
    for (std::size_t i = 0; i < ghosts.size(); ++i) {
        const double x = ghosts[i]->points.front().x;
        EXPECT_NEAR(x, 0.1 + gap * static_cast<double>(i + 1), 0.0011) << "ghost " << i;
    }
}

TEST(Scene, LongWaysGetMoreGhostsButNeverTooMany) {
    const auto ghosts = [](const std::vector<Point>& way) {
        return make_scene(make_exhibit(sample(3, way, {}, 0.005))).ghosts;
    };
    EXPECT_LT(ghosts({{0.1, 0.3}, {0.3, 0.3}}), ghosts({{0.1, 0.3}, {0.8, 0.3}}));
    std::vector<Point> to_and_fro;
    for (int i = 0; i < 40; ++i) to_and_fro.push_back({i % 2 == 0 ? 0.1 : 0.8, 0.3});
    EXPECT_LE(ghosts(to_and_fro), 36U);
}

TEST(Scene, EveryPathOfAnAsvLeadsFromItsStartToItsGoal) {
    const Exhibit exhibit = make_exhibit(sample(5, {{0.1, 0.3}, {0.4, 0.6}, {0.7, 0.3}}, {}));
    const Scene scene = make_scene(exhibit);
    for (std::size_t asv = 0; asv < 5; ++asv) {
        std::vector<Point> way;
        for (const SceneLine* line : lines_of(scene, Role::path)) {
            if (line->index != asv) continue;
            if (!way.empty()) {
                EXPECT_EQ(way.back(), line->points.front()) << "no gap";
            }
            way.insert(way.end(), line->points.begin(), line->points.end());
        }
        EXPECT_EQ(way.front(), exhibit.problem.start[asv]);
        EXPECT_NEAR(way.back().x, exhibit.problem.goal[asv].x, 1e-12);
        EXPECT_NEAR(way.back().y, exhibit.problem.goal[asv].y, 1e-12);
        EXPECT_LT(way.size(), 200U) << "straight stretches are simplified";
        double highest = 0;
        for (const Point& point : way) highest = std::max(highest, point.y);
        EXPECT_NEAR(highest, exhibit.problem.start[asv].y + 0.3, 1e-4) << "the bend is kept";
    }
}

TEST(Scene, MarksTheTightStretch) {
    // The lowest broom slides along the lower wall's top at 0.001, from 0.4 to 0.5.
    const Exhibit exhibit = make_exhibit(sample(3, {{0.1, 0.201}, {0.7, 0.201}}, two_walls()));
    const Scene scene = make_scene(exhibit);
    ASSERT_TRUE(scene.least);
    EXPECT_NEAR(scene.least->clearance, 0.001, 1e-12);
    EXPECT_NEAR(scene.least->link.a.y - scene.least->link.b.y, 0.001, 1e-12);
    EXPECT_LT(scene.least->first_state, scene.least->last_state);
    for (const Segment& link : scene.least->links) {
        EXPECT_GE(link.b.x, 0.4 - 1e-12);
        EXPECT_LE(link.b.x, 0.5 + 1e-12);
    }
    EXPECT_GT(scene.least->links.size(), 20U) << "it is a corridor, not a spot";
}

TEST(Scene, MarksTheWorstOfEachViolationThatTheValidatorFinds) {
    ExhibitInput input = sample(3, {{0.1, 0.15}, {0.7, 0.15}}, two_walls());
    const Exhibit exhibit = make_exhibit(std::move(input));
    ASSERT_FALSE(exhibit.report.valid());
    const Scene scene = make_scene(exhibit);
    ASSERT_EQ(scene.violations.size(), 1U);
    EXPECT_EQ(scene.violations[0].check, core::Check::collisions);
    const auto& checks = exhibit.report.checks;
    const auto collisions = std::find_if(checks.begin(), checks.end(), [](const auto& check) {
        return check.check == core::Check::collisions;
    });
    EXPECT_EQ(scene.violations[0].state, collisions->worst->state);
    EXPECT_EQ(geometry::distance(scene.violations[0].at, two_walls()[0]), 0);
    EXPECT_EQ(lines_of(scene, Role::violation).size(), 1U);
    EXPECT_EQ(exhibit.violations.size(), collisions->failures);
}

TEST(Scene, MarksWhatIsWrongWithAStartOrGoalWithoutAPath) {
    for (const bool goal : {false, true}) {
        ExhibitInput input = sample(3, {{0.1, 0.3}, {0.2, 0.3}}, {});
        input.solution.reset();
        auto& state = goal ? input.problem.goal : input.problem.start;
        state[2].x += 0.01;
        const Point middle{(state[1].x + state[2].x) / 2, (state[1].y + state[2].y) / 2};
        const Scene scene = make_scene(make_exhibit(std::move(input)));
        ASSERT_FALSE(scene.violations.empty());
        EXPECT_EQ(scene.violations[0].check, core::Check::broom_lengths);
        EXPECT_EQ(scene.violations[0].at, middle);
    }
}

TEST(Scene, TreesHaveAnEdgeForEachParentAndRoadmapsTheirOwn) {
    ExhibitInput input = sample(3, {{0.1, 0.3}, {0.2, 0.3}}, {});
    input.trees = SearchTrees{
        "prm", 3, {{"roadmap", {{0, 0}, {1, 0}, {1, 1}}, {-1, -1, -1}}}, {{0, 1}, {2, 1}}};
    const Scene scene = make_scene(make_exhibit(std::move(input)));
    ASSERT_EQ(scene.trees.size(), 1U);
    EXPECT_EQ(scene.trees[0].kind, SceneTree::Kind::roadmap);
    const std::vector<Segment> edges{{{0, 0}, {1, 0}}, {{1, 1}, {1, 0}}};
    EXPECT_EQ(scene.trees[0].edges, edges);
    EXPECT_EQ(scene.trees[0].nodes.size(), 3U);
    EXPECT_TRUE(scene.trees[0].roots.empty());
}

TEST(Facts, SayCostBoundRatioAndSteps) {
    ExhibitInput input = sample(3, {{0.1, 0.3}, {0.1 + 0.5, 0.3}}, {});
    input.lower_bound = 1;
    const Exhibit exhibit = make_exhibit(std::move(input));
    EXPECT_EQ(facts(exhibit),
              "3 ASVs · 0 obstacles · cost 1.5000 · lower bound 1.0000 (ratio 1.500) · 500 steps");
    EXPECT_EQ(verdict(exhibit), "valid");
    Exhibit in_metres = exhibit;
    in_metres.unit = "m";
    EXPECT_EQ(facts(in_metres),
              "3 ASVs · 0 obstacles · cost 1.5000 m · lower bound 1.0000 m (ratio 1.500) · "
              "500 steps");
    in_metres.problem.body = core::PlanarArm{};
    EXPECT_EQ(facts(in_metres).find(" m"), std::string::npos) << "that of an arm is an angle";
}

TEST(Facts, SayNoRatioOfAPathThatIsNotValid) {
    ExhibitInput input = sample(3, {{0.1, 0.3}, {0.1 + 1.5, 0.3}}, {});
    input.lower_bound = 4;
    input.planner = "auto";
    const Exhibit exhibit = make_exhibit(std::move(input));
    EXPECT_EQ(facts(exhibit),
              "3 ASVs · 0 obstacles · cost 4.5000 · lower bound 4.0000 · 1,500 steps · auto");
    EXPECT_EQ(verdict(exhibit), "not valid: 1 of 8 requirements violated") << "it leaves the field";
    EXPECT_EQ(complaints(exhibit).size(), 1U);
}

TEST(Facts, GroupDigits) {
    EXPECT_EQ(grouped(0), "0");
    EXPECT_EQ(grouped(999), "999");
    EXPECT_EQ(grouped(1000), "1,000");
    EXPECT_EQ(grouped(1234567), "1,234,567");
}

}  // namespace
}  // namespace asv::io
