#include "core/search/slide_and_pull.hpp"

#include <array>
#include <span>
#include <vector>

#include "core/model/problem.hpp"
#include "tests/kit/seeds.hpp"
#include "tests/kit/toy_planners.hpp"

namespace asv::core {
namespace {

using test::goal;
using test::PointSpace;
using test::start;

/// Searches in vain, since no way leads through the wall.
void search_at_wall(auto& space, std::size_t iterations, const SlideAndPullOptions& options) {
    Limits limits;
    limits.max_iterations = iterations;
    Rng rng(1);
    slide_and_pull(space, {start, goal}, options, limits, rng);
}

TEST(SlidePull, PullsItsShareOfTheIterations) {
    for (const double share : {0.0, 0.5, 1.0}) {
        PointSpace space(test::closed_wall());
        SlideAndPullOptions options;
        options.pull_share = share;
        search_at_wall(space, 1000, options);
        // One target in ten lies in the wall and is not pulled to.
        EXPECT_NEAR(static_cast<double>(space.pulls), 900 * share, 60);
    }
}

/// A body with two ends that notes which of them is pulled, on which side of the wall.
struct PulledEnds : PointSpace {
    using PointSpace::PointSpace;
    std::size_t asv_count() const { return 2; }
    Steered pull(std::span<const double> from, std::size_t asv, const geometry::Point& target,
                 Configurations& visited) {
        ++(from[0] < 0.5 ? left : right)[asv];
        return PointSpace::pull(from, asv, target, visited);
    }
    std::array<int, 2> left{}, right{};
};

TEST(SlidePull, TheEndThatLeadsOutOfTheStartComesLastIntoTheGoal) {
    for (const Leader leader : {Leader::first_asv, Leader::last_asv, Leader::either}) {
        PulledEnds space(test::closed_wall());
        SlideAndPullOptions options;
        options.leader = leader;
        search_at_wall(space, 300, options);
        const bool first = leader != Leader::last_asv, last = leader != Leader::first_asv;
        EXPECT_EQ(space.left[0] > 0, first);
        EXPECT_EQ(space.left[1] > 0, last);
        EXPECT_EQ(space.right[0] > 0, last);
        EXPECT_EQ(space.right[1] > 0, first);
    }
}

TEST(SlidePull, TheSmallerTreeGrows) {
    PointSpace space(test::closed_wall());
    Limits limits;
    limits.max_iterations = 500;
    Rng rng(1);
    const SearchResult result = slide_and_pull(space, {start, goal}, {}, limits, rng);
    const auto first = static_cast<double>(result.trees[0].size());
    EXPECT_NEAR(first / static_cast<double>(result.trees[1].size()), 1, 0.2);
}

/// From start to goal through the door of the wall.
std::vector<Point> way_through_the_door() {
    std::vector<Point> way;
    Point from{0.1, 0.1};
    for (const Point corner : {Point{0.45, 0.91}, Point{0.55, 0.91}, Point{0.9, 0.1}})
        for (int i = 0; i < 20; ++i) {
            from = {from.x + (corner.x - from.x) / (20 - i),
                    from.y + (corner.y - from.y) / (20 - i)};
            way.push_back(from);
        }
    return way;
}

TEST(SlidePull, FindsADoorSoonerAlongAWayThatLeadsThroughIt) {
    std::size_t with = 0, without = 0;
    test::for_seeds(20, [&](Rng& rng) {
        for (const bool guided : {false, true}) {
            PointSpace space(test::wall_with_door());
            if (guided) space.way = way_through_the_door();
            const SearchResult result = slide_and_pull(space, {start, goal}, {}, {}, rng);
            ASSERT_EQ(result.outcome, Outcome::solved);
            (guided ? with : without) += result.iterations;
        }
    });
    EXPECT_LT(with, without / 2);
}

}  // namespace
}  // namespace asv::core
