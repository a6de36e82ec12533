#include <cmath>
#include <iostream>
#include <numbers>
#include <optional>

#include "core/search/trees/two_trees.hpp"
#include "core/solve/planning_frame.hpp"
#include "core/space/proof/motion_checker.hpp"
#include "core/space/sampling/shape_sampler.hpp"
#include "tests/kit/oracle.hpp"

namespace asv::core {
namespace {

using testing::between;
using testing::for_seeds;
using testing::Oracle;
using testing::Points;
using testing::ring;
using testing::Row;
using testing::scaled;

/// Rounding of the checker and of the oracle; far below every margin.
constexpr double rounding = 1e-12;

/// A world of n ASVs among random boxes, and motions in it.
struct Place {
    Place(Rng& rng, std::size_t n, std::size_t boxes, double size, Anchor anchor)
        : world(testing::cluttered(rng, n, boxes, size), anchor),
          checker(world.make_checker()),
          sampler(checker),
          oracle(world) {}

    Row state(Rng& rng) {
        Row row(world.start);
        while (!sampler.sample(rng, row)) continue;
        return row;
    }

    /// To another place and shape, or only a little off, or changed in one respect alone.
    Row target(Rng& rng, const Row& from) {
        const std::size_t kind = rng.below(5);
        if (kind == 0) {
            Row to = state(rng);
            unwrap(to, from, WrappingAngles{2, to.size() > 2 ? 1U : 0U});
            return to;
        }
        Row to(from);
        const double size = std::pow(10, rng.uniform(-4, 0));
        for (std::size_t i = 0; i < to.size(); ++i) {
            if (kind == 2 && i >= 2) break;
            if (kind == 3 && i != 2) continue;
            if (kind == 4 && i < 3) continue;
            to[i] += size * rng.normal() * (i < 2 ? 0.2 : 1);
            if (i > 2) to[i] = std::abs(to[i]);
        }
        return to;
    }

    /// Half of the motions begin where another one was blocked: in contact.
    Row beginning(Rng& rng) {
        const Row from = state(rng);
        if (rng.chance(0.5)) return from;
        const Row to = target(rng, from);
        return between(from, to, std::max(0.0, checker.valid_prefix(from, to, 1e-4)));
    }

    ChainWorld world;
    MotionChecker checker;
    ShapeSampler sampler;
    Oracle oracle;
};

struct Kind {
    std::size_t asvs, boxes;
    double size;
    Anchor anchor;
};
constexpr Kind kinds[] = {
    {1, 30, 0.1, Anchor::first_asv}, {1, 30, 0.1, Anchor::centroid},
    {3, 10, 0.2, Anchor::centroid},  {3, 60, 0.06, Anchor::first_asv},
    {5, 40, 0.08, Anchor::centroid}, {7, 10, 0.1, Anchor::first_asv},
    {7, 60, 0.03, Anchor::centroid}, {15, 20, 0.06, Anchor::centroid},
};

/// Calls body(place, from, to) for random motions in worlds of every kind.
template <class Body>
void for_motions(std::size_t worlds, std::size_t motions, Body&& body) {
    for_seeds(worlds, [&](Rng& rng) {
        for (const Kind& kind : kinds) {
            SCOPED_TRACE(std::to_string(kind.asvs) + " ASVs, " + std::to_string(kind.boxes) +
                         " boxes");
            Place place(rng, kind.asvs, kind.boxes, kind.size, kind.anchor);
            for (std::size_t i = 0; i < motions; ++i) {
                SCOPED_TRACE("motion " + std::to_string(i));
                const Row from = place.beginning(rng);
                body(place, from, place.target(rng, from));
                if (::testing::Test::HasFailure()) return;
            }
        }
    });
}

TEST(Motion, WhatIsCertifiedIsValidAndLittleElseIsRefused) {
    std::size_t certified = 0, blocked = 0, refuted = 0;
    for_motions(scaled(5), 120, [&](Place& place, const Row& from, const Row& to) {
        const Oracle::Lowest worst = place.oracle.lowest(from, to, 250);
        if (place.checker.valid(from, to)) {
            ++certified;
            ASSERT_GE(worst.room, -rounding) << "at " << worst.t;
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
    for_motions(1, scaled(20), [&](Place& place, const Row& from, const Row& aim) {
        // At most five primitive steps of it.
        const double share = std::min(1.0, 0.005 / (1e-9 + place.oracle.moved(from, aim)));
        const Row to = between(from, aim, share);
        if (!place.checker.valid(from, to)) return;
        const auto samples = static_cast<int>(1e6 * place.oracle.moved(from, to)) + 1;
        for (int i = 0; i <= samples; ++i) {
            const Row row = between(from, to, static_cast<double>(i) / samples);
            ASSERT_GE(place.oracle.room(row), -rounding) << "sample " << i;
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
    for_motions(scaled(5), 300, [&](Place& place, const Row&, const Row& row) {
        const double room = place.oracle.room(row);
        if (std::abs(room) < rounding) return;
        ASSERT_EQ(place.checker.valid(row), room > 0) << "room " << room;
        (room > 0 ? valid : invalid) += 1;
    });
    EXPECT_GT(valid, 100U);
    EXPECT_GT(invalid, 100U);
}

TEST(Motion, PrefixEndsShortlyBeforeTheFirstInvalidState) {
    std::size_t blocked = 0, early = 0;
    for_motions(scaled(5), 100, [&](Place& place, const Row& from, const Row& to) {
        for (const double resolution : {1e-2, 1e-4}) {
            const double proven = place.checker.valid_prefix(from, to, resolution);
            ASSERT_LE(proven, 1);
            if (proven < 0) {
                ASSERT_LE(place.oracle.room(from), rounding);
                continue;
            }
            const Row end = between(from, to, proven);
            ASSERT_GE(place.oracle.lowest(from, end, 100).room, -rounding);
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
    for_motions(scaled(5), 200, [&](Place& place, const Row& from, const Row& to) {
        const bool whole = place.checker.valid_prefix(from, to, 1e-3) >= 1;
        ASSERT_EQ(place.checker.valid(from, to), whole);
    });
}

/// The answers for a motion and its image have to agree, but where it is a matter of rounding.
void expect_same_answers(Place& place, const PlanningFrame& frame, Points (*map)(Points),
                         Rng& rng) {
    const ChainWorld image(frame.problem(), Anchor::centroid);
    MotionChecker checker = image.make_checker();
    const auto image_of = [&](const Row& row) {
        Points points = map(testing::positions_of(place.world.chain, row));
        if (frame.transposed())
            for (Point& p : points) std::swap(p.x, p.y);
        return testing::row_of(image.chain, points);
    };
    std::size_t yes = 0, no = 0;
    for (int i = 0; i < 200; ++i) {
        const Row from = place.beginning(rng), to = place.target(rng, from);
        if (to.size() > 2 && std::abs(to[2] - from[2]) > 1) continue;
        const Row a = image_of(from);
        Row b = image_of(to);
        unwrap(b, a, WrappingAngles{2, 1});
        const bool answer = place.checker.valid(from, to);
        if (std::abs(place.oracle.lowest(from, to, 100).room) < 1e-6) continue;
        ASSERT_EQ(checker.valid(a, b), answer) << "motion " << i;
        (answer ? yes : no) += 1;
    }
    EXPECT_GT(yes, 10U);
    EXPECT_GT(no, 10U);
}

Problem image(Problem problem, Points (*map)(Points)) {
    problem.start = map(problem.start);
    problem.goal = map(problem.goal);
    for (Box& box : problem.obstacles) {
        const Points corners = map({box.low, box.high});
        box = geometry::bounds(geometry::Segment{corners[0], corners[1]});
    }
    return problem;
}

TEST(Motion, MirrorsRotationsAndTheOtherWayAlongTheChainChangeNothing) {
    Points (*const maps[])(Points) = {
        [](Points points) {
            for (Point& p : points) p.x = 1 - p.x;
            return points;
        },
        [](Points points) {
            for (Point& p : points) std::swap(p.x, p.y);
            return points;
        },
        [](Points points) {
            for (Point& p : points) p = {1 - p.y, p.x};
            return points;
        },
        testing::reversed,
    };
    for_seeds(scaled(4), [&](Rng& rng) {
        for (std::size_t which = 0; which < std::size(maps); ++which) {
            SCOPED_TRACE("image " + std::to_string(which));
            Place place(rng, 7, 30, 0.05, Anchor::centroid);
            const PlanningFrame frame(image(place.world.problem, maps[which]));
            expect_same_answers(place, frame, maps[which], rng);
        }
    });
}

TEST(Motion, AThousandBoxesGiveTheAnswersOfTheirParts) {
    Rng rng(1);
    Place place(rng, 5, 1000, 0.011, Anchor::centroid);
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
    Place place(rng, 3, 10, 0.1, Anchor::centroid);
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
    Place place(rng, 3, 10, 0.1, Anchor::centroid);
    const Row row = place.state(rng);
    const auto states = place.checker.state_checks(), motions = place.checker.motion_checks();
    place.checker.valid(row, row);
    EXPECT_GT(place.checker.state_checks(), states);
    EXPECT_EQ(place.checker.motion_checks(), motions + 1);
}

}  // namespace
}  // namespace asv::core
