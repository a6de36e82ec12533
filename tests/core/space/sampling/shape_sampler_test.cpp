#include "core/space/sampling/shape_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include "tests/kit/sampling_field.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using std::numbers::pi;
using test::for_seeds;
using test::Points;
using test::ring;
using test::Row;
using test::SamplingField;

TEST(ShapeSampler, SamplesAreValid) {
    for (const std::size_t n : {1U, 3U, 4U, 7U, 15U, 25U}) {
        SCOPED_TRACE(std::to_string(n) + " ASVs");
        SamplingField field(n, n < 25 ? test::box_in_the_middle() : std::vector<Box>{},
                            Anchor::centroid);
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
    SamplingField field(7, test::box_in_the_middle(), Anchor::centroid);
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
    Problem problem = test::problem(ring(7, {0.5, 0.5}, 0), ring(7, {0.5, 0.5}, 0));
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

}  // namespace
}  // namespace asv::core
