#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/bounds/feasibility.hpp"
#include "core/generate/families.hpp"
#include "core/generate/vouch/vouch.hpp"
#include "core/validation/validate.hpp"

/// Problems without a path, and those of one ASV, of every family.

namespace asv::core {
namespace {

struct Drawer {
    std::string name;
    std::function<Problem(const ChainOptions&, Rng&)> draw;
};

template <class Options>
Drawer drawer(std::string name, Problem (*draw)(const Options&, Rng&)) {
    return {std::move(name), [draw](const ChainOptions& chain, Rng& rng) {
                Options options;
                options.chain = chain;
                return draw(options, rng);
            }};
}

std::vector<Drawer> drawers() {
    return {drawer("corridor", corridor), drawer("bend", bend),      drawer("gauntlet", gauntlet),
            drawer("rooms", rooms),       drawer("maze", maze),      drawer("spiral", spiral),
            drawer("crossing", crossing), drawer("clutter", clutter)};
}

template <class Body>
void for_each_problem(const ChainOptions& chain, const Body& body) {
    for (const Drawer& family : drawers())
        for (std::uint64_t seed = 1; seed <= 3; ++seed) {
            SCOPED_TRACE(family.name + ", seed " + std::to_string(seed));
            Rng rng(seed);
            body(family.draw(chain, rng));
        }
}

/// Of every family, small ones and larger ones.
template <class Body>
void for_each_obstructed(Obstruction obstruction, const Body& body) {
    for (const std::size_t n : {3U, 6U}) {
        ChainOptions chain;
        chain.asv_count = n;
        chain.obstruction = obstruction;
        for_each_problem(chain, body);
    }
}

void expect_valid_ends(const Problem& problem) {
    for (const auto* end : {&problem.start, &problem.goal})
        EXPECT_TRUE(validate_state(problem, *end, {.tolerance = 1e-9}).valid());
}

TEST(Obstruction, ATurnedGoalIsProvenToBeOutOfReach) {
    for_each_obstructed(Obstruction::turned, [](const Problem& problem) {
        expect_valid_ends(problem);
        EXPECT_EQ(check_feasibility(problem).cause, Infeasibility::opposite_orientation);
        EXPECT_FALSE(vouch(problem).solvable);
    });
}

TEST(Obstruction, AFencedGoalIsProvenToBeOutOfReach) {
    for_each_obstructed(Obstruction::fenced, [](const Problem& problem) {
        expect_valid_ends(problem);
        EXPECT_EQ(check_feasibility(problem).cause, Infeasibility::separated);
        Problem open = problem;
        open.obstacles.resize(open.obstacles.size() - 4);
        EXPECT_EQ(check_feasibility(open).cause, Infeasibility::none);
    });
}

TEST(Obstruction, WithoutOneTheProblemIsWhatItWas) {
    ChainOptions chain;
    chain.asv_count = 5;
    for (const Drawer& family : drawers()) {
        Rng plain(4), fenced(4);
        const Problem one = family.draw(chain, plain);
        ChainOptions other = chain;
        other.obstruction = Obstruction::fenced;
        EXPECT_EQ(family.draw(other, fenced).start, one.start) << family.name;
    }
}

TEST(OneAsv, HasAPlaceInEveryFamily) {
    ChainOptions chain;
    chain.asv_count = 1;
    for_each_problem(chain, [](const Problem& problem) {
        ASSERT_EQ(problem.start.size(), 1U);
        expect_valid_ends(problem);
        for (const Point& point : {problem.start.front(), problem.goal.front()})
            for (const Box& box : problem.obstacles)
                EXPECT_FALSE(point.x >= box.low.x && point.x <= box.high.x &&
                             point.y >= box.low.y && point.y <= box.high.y);
        EXPECT_FALSE(vouch(problem).solvable);
    });
}

TEST(OneAsv, CannotBeObstructed) {
    CorridorOptions options;
    options.chain.asv_count = 1;
    for (const Obstruction obstruction : {Obstruction::turned, Obstruction::fenced}) {
        options.chain.obstruction = obstruction;
        Rng rng(1);
        EXPECT_THROW(corridor(options, rng), std::invalid_argument);
    }
}

}  // namespace
}  // namespace asv::core
