#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include "core/space/sampling/corridors.hpp"
#include "core/space/sampling/passage_points.hpp"
#include "core/space/sampling/shape_sampler.hpp"
#include "core/space/sampling/stepwise_sampler.hpp"
#include "tests/kit/oracle.hpp"

namespace asv::core {
namespace {

using testing::for_seeds;
using testing::Oracle;
using testing::Points;
using testing::ring;
using testing::Row;

constexpr double pi = std::numbers::pi;
constexpr Box unit{{0, 0}, {1, 1}};

struct Field {
    Field(std::size_t n, std::vector<Box> boxes, Anchor anchor)
        : world(testing::problem(ring(n, {0.25, 0.25}, 0), ring(n, {0.75, 0.75}, 0),
                                 std::move(boxes)),
                anchor),
          checker(world.make_checker()),
          oracle(world) {}

    ChainWorld world;
    MotionChecker checker;
    Oracle oracle;
};

const std::vector<Box> middle{{{0.45, 0.45}, {0.55, 0.55}}};

TEST(ShapeSampler, SamplesAreValid) {
    for (const std::size_t n : {1U, 3U, 4U, 7U, 15U, 25U}) {
        SCOPED_TRACE(std::to_string(n) + " ASVs");
        Field field(n, n < 25 ? middle : std::vector<Box>{}, Anchor::centroid);
        ShapeSampler sampler(field.checker);
        std::size_t found = 0;
        for_seeds(100, [&](Rng& rng) {
            Row row(field.world.chain.dimension());
            if (!sampler.sample(rng, row)) return;
            ++found;
            ASSERT_GE(field.oracle.room(row), 0);
            ASSERT_TRUE(field.oracle.judged_valid(row));
        });
        // A ring of 25 is 0.4 across: few places in the field have room for it.
        EXPECT_GE(found, n < 25 ? 90U : 70U);
    }
}

TEST(ShapeSampler, SamplesSpreadOverPlacesHeadingsAndShapes) {
    Field field(7, middle, Anchor::centroid);
    ShapeSampler sampler(field.checker);
    std::set<int> places, headings;
    std::size_t sharp = 0, even = 0;
    Rng rng(1);
    for (int i = 0; i < 1000; ++i) {
        Row row(8);
        ASSERT_TRUE(sampler.sample(rng, row));
        places.insert(static_cast<int>(row[0] * 3) * 3 + static_cast<int>(row[1] * 3));
        headings.insert(static_cast<int>((row[2] + pi) / (2 * pi) * 8));
        const double sum = std::accumulate(row.begin() + 3, row.end(), 0.0);
        const double most = *std::max_element(row.begin() + 3, row.end());
        sharp += most > 0.35 * sum;
        even += most < 0.28 * sum;
    }
    EXPECT_GE(places.size(), 8U);
    EXPECT_EQ(headings.size(), 8U);
    EXPECT_GE(sharp, 50U);
    EXPECT_GE(even, 50U);
}

TEST(ShapeSampler, GivesUpWhereNothingFits) {
    Problem problem = testing::problem(ring(7, {0.5, 0.5}, 0), ring(7, {0.5, 0.5}, 0));
    // A room that holds the ring as it stands, and hardly anything else.
    problem.requirements.bounds = {problem.start[0], problem.start[0]};
    for (const Point& p : problem.start) {
        Box& b = problem.requirements.bounds;
        b = {{std::min(b.low.x, p.x), std::min(b.low.y, p.y)},
             {std::max(b.high.x, p.x), std::max(b.high.y, p.y)}};
    }
    const ChainWorld world(problem, Anchor::centroid);
    MotionChecker checker = world.make_checker();
    ShapeSampler sampler(checker);
    Rng rng(1);
    Row row(8);
    EXPECT_FALSE(sampler.sample(rng, row));
    EXPECT_TRUE(sampler.sample_shape(rng, row));
}

using From = StepwiseSampler::From;

TEST(StepwiseSampler, SamplesAreValidAndKeepToTheirRange) {
    constexpr double sharpest = 1.2;
    for (const From from : {From::first_asv, From::last_asv}) {
        for (const std::size_t n : {1U, 3U, 5U, 7U}) {
            SCOPED_TRACE(std::to_string(n) + " ASVs");
            Field field(n, middle, Anchor::first_asv);
            StepwiseSampler sampler(field.checker, sharpest);
            std::size_t found = 0, beyond = 0;
            for_seeds(2000, [&](Rng& rng) {
                const bool any_turn = rng.chance(0.5);
                Row row(field.world.chain.dimension());
                if (!sampler.sample(rng, from, std::nullopt, any_turn, row)) return;
                ++found;
                ASSERT_GE(field.oracle.room(row), 0);
                for (std::size_t i = 3; i < row.size(); ++i) {
                    ASSERT_GE(row[i], 0);
                    if (row[i] <= sharpest + 1e-9) continue;
                    ASSERT_TRUE(any_turn) << "a turn of " << row[i];
                    ++beyond;
                }
            });
            EXPECT_GE(found, 40U);
            if (n >= 3) {
                EXPECT_GE(beyond, 5U);
            }
        }
    }
}

TEST(StepwiseSampler, PutsTheEndWhereItIsTold) {
    Field field(5, middle, Anchor::first_asv);
    StepwiseSampler sampler(field.checker, pi);
    const Point place{0.3, 0.6};
    Row row(6);
    std::size_t found = 0;
    for_seeds(300, [&](Rng& rng) {
        for (const From from : {From::first_asv, From::last_asv}) {
            if (!sampler.sample(rng, from, place, true, row)) continue;
            ++found;
            const Points points = testing::positions_of(field.world.chain, row);
            const Point& end = from == From::first_asv ? points.front() : points.back();
            ASSERT_NEAR(end.x, place.x, 1e-12);
            ASSERT_NEAR(end.y, place.y, 1e-12);
        }
        ASSERT_FALSE(sampler.sample(rng, From::first_asv, Point{0.5, 0.5}, true, row));
    });
    EXPECT_GE(found, 20U);
}

TEST(Corridors, FindsTheGapsBetweenBoxesThatFaceEachOther) {
    const std::vector<Box> boxes{{{0.3, 0.3}, {0.6, 0.5}}, {{0.4, 0.55}, {0.8, 0.7}}};
    const Corridors corridors(boxes, unit, 0.1);
    ASSERT_EQ(corridors.gaps().size(), 1U);
    EXPECT_EQ(corridors.gaps()[0], (Box{{0.4, 0.5}, {0.6, 0.55}}));
    for_seeds(100, [&](Rng& rng) {
        const auto point = corridors.sample(rng);
        ASSERT_TRUE(point);
        ASSERT_TRUE(geometry::contains(corridors.gaps()[0], *point));
    });
}

TEST(Corridors, ABoxAndTheBoundsFaceEachOtherAsWell) {
    const std::vector<Box> boxes{{{0.05, 0.4}, {0.5, 0.95}}};
    const Corridors corridors(boxes, unit, 0.1);
    const std::vector<Box> expected{{{0, 0.4}, {0.05, 0.95}}, {{0.05, 0.95}, {0.5, 1}}};
    ASSERT_EQ(corridors.gaps().size(), 2U);
    for (const Box& gap : expected)
        EXPECT_EQ(std::count(corridors.gaps().begin(), corridors.gaps().end(), gap), 1);
}

TEST(Corridors, WideGapsAndOverlapsAreNone) {
    Rng rng(1);
    EXPECT_FALSE(Corridors({}, unit, 0.5).sample(rng));
    const std::vector<Box> far{{{0.3, 0.2}, {0.6, 0.4}}, {{0.3, 0.6}, {0.6, 0.8}}};
    EXPECT_TRUE(Corridors(far, unit, 0.19).gaps().empty());
    EXPECT_FALSE(Corridors(far, unit, 0.21).gaps().empty());
    const std::vector<Box> overlapping{{{0.3, 0.3}, {0.6, 0.6}}, {{0.5, 0.5}, {0.7, 0.7}}};
    EXPECT_TRUE(Corridors(overlapping, unit, 0.1).gaps().empty());
}

TEST(PassagePoints, LieInTheDoorFarMoreOftenThanByChance) {
    const std::vector<Box> boxes{{{0.45, -1}, {0.55, 0.45}}, {{0.45, 0.55}, {0.55, 2}}};
    const ObstacleField field(boxes);
    const Box door{{0.45, 0.45}, {0.55, 0.55}};
    std::size_t found = 0, in_door = 0;
    for_seeds(2000, [&](Rng& rng) {
        const auto point = passage_point(field, unit, rng);
        if (!point) return;
        ++found;
        ASSERT_FALSE(field.contains(*point));
        ASSERT_TRUE(geometry::contains(unit, *point));
        in_door += geometry::contains(door, *point);
    });
    EXPECT_GE(found, 300U);
    // The door is a hundredth of the field.
    EXPECT_GE(in_door, found / 5);
}

TEST(PassagePoints, AnOpenFieldHasNone) {
    Rng rng(1);
    EXPECT_FALSE(passage_point(ObstacleField({}), unit, rng));
}

TEST(FreePoints, AreFreeAndEverywhere) {
    const ObstacleField field(middle);
    std::set<int> places;
    for_seeds(300, [&](Rng& rng) {
        const auto point = free_point(field, unit, rng);
        ASSERT_TRUE(point);
        ASSERT_FALSE(field.contains(*point));
        places.insert(static_cast<int>(point->x * 4) * 4 + static_cast<int>(point->y * 4));
    });
    EXPECT_EQ(places.size(), 16U);
    const std::vector<Box> everywhere{unit};
    Rng rng(1);
    EXPECT_FALSE(free_point(ObstacleField(everywhere), unit, rng));
}

}  // namespace
}  // namespace asv::core
