#include "core/search/rrt.hpp"

#include "tests/kit/toy_planners.hpp"

namespace asv::core {
namespace {

using test::goal;
using test::PointSpace;
using test::start;

TEST(Rrt, StepsAreAtMostAsLongAsTheyMayBe) {
    PointSpace space(test::wall_with_door());
    Rng rng(4);
    RrtOptions options;
    options.step = 0.03;
    const SearchResult result = rrt(space, {start, goal}, options, {}, rng);
    const Tree& tree = result.trees[0];
    for (std::uint32_t node = 1; node < tree.size(); ++node)
        ASSERT_LE(space.distance(tree.row(tree.parent(node)), tree.row(node)), 0.03 + 1e-12);
}

TEST(Rrt, GoesStraightWhereNothingIsInTheWay) {
    PointSpace space({});
    Rng rng(1);
    const SearchResult result = rrt(space, {start, goal}, {}, {}, rng);
    EXPECT_EQ(result.path, (Configurations{0.1, 0.1, 0.9, 0.1}));
    EXPECT_EQ(result.trees[0].size(), 2U);
}

}  // namespace
}  // namespace asv::core
