#include "core/space/proof/motion_checker.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

#include "tests/kit/chains/motion_worlds.hpp"
#include "tests/kit/scaled.hpp"

/// Motions and states against the oracle.

namespace asv::core {
namespace {

using test::between;
using test::for_motions;
using test::MotionWorld;
using test::Oracle;
using test::Row;
using test::scaled;

/// Rounding of the checker and of the oracle; far below every margin.
constexpr double rounding_of_checks = 1e-12;

TEST(Motion, WhatIsCertifiedIsValidAndLittleElseIsRefused) {
    std::size_t certified = 0, blocked = 0, refuted = 0;
    for_motions(scaled(5), 120, [&](MotionWorld& place, const Row& from, const Row& to) {
        const Oracle::Lowest worst = place.oracle.lowest(from, to, 250);
        if (place.checker.valid(from, to)) {
            ++certified;
            ASSERT_GE(worst.room, -rounding_of_checks) << "at " << worst.t;
            ASSERT_TRUE(place.oracle.judged_valid(between(from, to, worst.t)));
        } else if (worst.room > 1e-6) {
            ++refuted;
        } else {
            ++blocked;
        }
    });
    const double share = static_cast<double>(refuted) / static_cast<double>(certified + refuted);
    std::cout << certified << " motions certified, " << blocked << " blocked, " << refuted
              << " refuted though valid (" << 100 * share << " %)\n";
    EXPECT_GE(certified, 100U);
    EXPECT_GE(blocked, 100U);
    EXPECT_LT(share, 0.01);
}

TEST(Motion, ThousandSamplesForEveryPrimitiveStepFindNothing) {
    std::size_t looked_at = 0;
    for_motions(1, scaled(20), [&](MotionWorld& place, const Row& from, const Row& aim) {
        // At most five primitive steps of it.
        const double share = std::min(1.0, 0.005 / (1e-9 + place.oracle.moved(from, aim)));
        const Row to = between(from, aim, share);
        if (!place.checker.valid(from, to)) return;
        const auto samples = static_cast<int>(1e6 * place.oracle.moved(from, to)) + 1;
        for (int i = 0; i <= samples; ++i) {
            const Row row = between(from, to, static_cast<double>(i) / samples);
            ASSERT_GE(place.oracle.room(row), -rounding_of_checks) << "sample " << i;
            if (i % 10 == 0) {
                ASSERT_TRUE(place.oracle.judged_valid(row)) << "sample " << i;
            }
        }
        ++looked_at;
    });
    EXPECT_GT(looked_at, 0U);
}

TEST(Motion, StatesAreJudgedAsByTheOracle) {
    std::size_t valid = 0, invalid = 0;
    for_motions(scaled(5), 300, [&](MotionWorld& place, const Row&, const Row& row) {
        const double room = place.oracle.room(row);
        if (std::abs(room) < rounding_of_checks) return;
        ASSERT_EQ(place.checker.valid(row), room > 0) << "room " << room;
        (room > 0 ? valid : invalid) += 1;
    });
    EXPECT_GT(valid, 100U);
    EXPECT_GT(invalid, 100U);
}

TEST(Motion, PrefixEndsShortlyBeforeTheFirstInvalidState) {
    std::size_t blocked = 0, early = 0;
    for_motions(scaled(5), 100, [&](MotionWorld& place, const Row& from, const Row& to) {
        for (const double resolution : {1e-2, 1e-4}) {
            const double proven = place.checker.valid_prefix(from, to, resolution);
            ASSERT_LE(proven, 1);
            if (proven < 0) {
                ASSERT_LE(place.oracle.room(from), rounding_of_checks);
                continue;
            }
            const Row end = between(from, to, proven);
            ASSERT_GE(place.oracle.lowest(from, end, 100).room, -rounding_of_checks);
            if (proven >= 1) continue;
            ++blocked;
            // No ASV gets farther than the resolution from where the motion stopped.
            double beyond = proven;
            while (beyond < 1 && place.oracle.moved(end, between(from, to, beyond)) < resolution)
                beyond += 0.001 * (1 - proven);
            const Row reach = between(from, to, std::min(beyond, 1.0));
            if (place.oracle.lowest(end, reach, 100).room > 1e-6) ++early;
        }
    });
    std::cout << blocked << " motions blocked, " << early << " of them too early\n";
    EXPECT_GT(blocked, 100U);
    EXPECT_LE(early, blocked / 200);
}

TEST(Motion, AWholeMotionIsValidWhenItsPrefixSaysSo) {
    for_motions(scaled(5), 200, [&](MotionWorld& place, const Row& from, const Row& to) {
        const bool whole = place.checker.valid_prefix(from, to, 1e-3) >= 1;
        ASSERT_EQ(place.checker.valid(from, to), whole);
    });
}

TEST(Motion, AThousandBoxesGiveTheAnswersOfTheirParts) {
    Rng rng(1);
    MotionWorld place(rng, 5, 1000, 0.011, Anchor::centroid);
    // Checkers that know few enough boxes to look at all of them.
    std::vector<ChainConstraints> limits;
    std::vector<ObstacleField> fields;
    const auto& boxes = place.world.constraints.obstacles;
    for (std::size_t i = 0; i < boxes.size(); i += 10) {
        limits.push_back(place.world.constraints);
        fields.emplace_back(
            std::span(boxes).subspan(i, std::min<std::size_t>(10, boxes.size() - i)));
    }
    ASSERT_TRUE(fields[0].few());
    ASSERT_FALSE(place.world.field.few());
    std::size_t yes = 0, no = 0;
    for (int i = 0; i < 400; ++i) {
        const Row from = place.beginning(rng), to = place.target(rng, from);
        bool all = true;
        for (std::size_t part = 0; part < fields.size(); ++part)
            all =
                all && MotionChecker(place.world.chain, limits[part], fields[part]).valid(from, to);
        if (place.checker.valid(from, to) != all) {
            EXPECT_LT(std::abs(place.oracle.lowest(from, to, 300).room), 1e-6) << "motion " << i;
        }
        (all ? yes : no) += 1;
    }
    EXPECT_GT(yes, 20U);
    EXPECT_GT(no, 20U);
}

TEST(Motion, WhatIsNoNumberIsNotValid) {
    Rng rng(1);
    MotionWorld place(rng, 3, 10, 0.1, Anchor::centroid);
    const Row from = place.state(rng);
    for (std::size_t i = 0; i < from.size(); ++i) {
        Row to(from);
        to[i] = std::nan("");
        EXPECT_FALSE(place.checker.valid(to)) << "coordinate " << i;
        EXPECT_FALSE(place.checker.valid(from, to)) << "coordinate " << i;
        EXPECT_LE(place.checker.valid_prefix(from, to, 1e-3), 0) << "coordinate " << i;
    }
}

TEST(Motion, CountsItsWork) {
    Rng rng(1);
    MotionWorld place(rng, 3, 10, 0.1, Anchor::centroid);
    const Row row = place.state(rng);
    const auto states = place.checker.state_checks(), motions = place.checker.motion_checks();
    place.checker.valid(row, row);
    EXPECT_GT(place.checker.state_checks(), states);
    EXPECT_EQ(place.checker.motion_checks(), motions + 1);
}

}  // namespace
}  // namespace asv::core
