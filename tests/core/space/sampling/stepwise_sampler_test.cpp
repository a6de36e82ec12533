#include "core/space/sampling/stepwise_sampler.hpp"

#include <numbers>
#include <optional>

#include "tests/kit/sampling_field.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using std::numbers::pi;
using test::for_seeds;
using test::Points;
using test::Row;
using test::SamplingField;

using From = StepwiseSampler::From;

TEST(StepwiseSampler, SamplesAreValidAndKeepToTheirRange) {
    constexpr double sharpest = 1.2;
    for (const From from : {From::first_asv, From::last_asv}) {
        for (const std::size_t n : {1U, 3U, 5U, 7U}) {
            SCOPED_TRACE(std::to_string(n) + " ASVs");
            SamplingField field(n, test::box_in_the_middle(), Anchor::first_asv);
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
    SamplingField field(5, test::box_in_the_middle(), Anchor::first_asv);
    StepwiseSampler sampler(field.checker, pi);
    const Point place{0.3, 0.6};
    Row row(6);
    std::size_t found = 0;
    for_seeds(300, [&](Rng& rng) {
        for (const From from : {From::first_asv, From::last_asv}) {
            if (!sampler.sample(rng, from, place, true, row)) continue;
            ++found;
            const Points points = test::positions_of(field.world.chain, row);
            const Point& end = from == From::first_asv ? points.front() : points.back();
            ASSERT_NEAR(end.x, place.x, 1e-12);
            ASSERT_NEAR(end.y, place.y, 1e-12);
        }
        ASSERT_FALSE(sampler.sample(rng, From::first_asv, Point{0.5, 0.5}, true, row));
    });
    EXPECT_GE(found, 20U);
}

}  // namespace
}  // namespace asv::core
