#include "core/routes/route_search.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "core/space/motion_cost.hpp"
#include "tests/kit/chains/configuration_oracle.hpp"
#include "tests/kit/chains/two_doors.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

constexpr double nothing_known = std::numeric_limits<double>::infinity();

RouteSearchOptions options() {
    RouteSearchOptions options;
    options.limits.max_iterations = 2000;
    return options;
}

/// Does ASV 1 pass the wall through the upper door?
bool goes_through_far_door(const ChainWorld& world, const Configurations& path) {
    Pose pose = world.chain.make_pose();
    const std::size_t d = world.chain.dimension();
    for (std::size_t i = 0; i < path.size(); i += d) {
        world.chain.forward({path.data() + i, d}, pose);
        if (pose.x[0] > 0.5 && pose.x[0] < 0.6) return pose.y[0] > 0.6;
    }
    return false;
}

TEST(RouteSearch, TriesBothDoorsAndItsPathsAreValidWhereAllGatesAreOpen) {
    const ChainWorld world(test::two_doors(), Anchor::centroid);
    RouteSearch routes(world, options());
    Rng rng(1);
    int through_far_door = 0, found = 0;
    while (routes.has_untried(nothing_known)) {
        const RouteSearch::Found path = routes.search_along_route(nothing_known, rng);
        EXPECT_GT(path.work, 0);
        if (path.path.empty()) continue;
        ++found;
        test::Oracle(world).expect_valid_path(path.path);
        through_far_door += goes_through_far_door(world, path.path) ? 1 : 0;
        routes.note_cost(MotionCost(world.chain).path(path.path));
    }
    EXPECT_GE(found, 3 + 2);
    EXPECT_GE(through_far_door, 2);
    EXPECT_LE(through_far_door, found - 2);
}

TEST(RouteSearch, LeavesOutWaysThatCannotBeBetter) {
    const ChainWorld world(test::two_doors(), Anchor::centroid);
    RouteSearch routes(world, options());
    Rng rng(1);
    const double shortest = Ways(world.problem).next()->bound;
    int tried = 0;
    for (; routes.has_untried(shortest + 0.1); ++tried)
        routes.search_along_route(shortest + 0.1, rng);
    EXPECT_EQ(tried, 3) << "the leaders of the first class";
}

TEST(RouteSearch, SearchesBetweenAnyTwoConfigurations) {
    const ChainWorld world(test::two_doors(), Anchor::centroid);
    RouteSearch routes(world, options());
    Rng rng(1);
    const auto found = routes.search_between({world.goal, world.start}, Leader::first_asv, rng);
    ASSERT_FALSE(found.path.empty());
    const auto d = static_cast<std::ptrdiff_t>(world.chain.dimension());
    EXPECT_EQ(Configurations(found.path.begin(), found.path.begin() + d), world.goal);
}

}  // namespace
}  // namespace asv::core
