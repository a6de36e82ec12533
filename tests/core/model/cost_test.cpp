#include "core/model/cost.hpp"

#include <gtest/gtest.h>

#include "tests/kit/chains/chains.hpp"

namespace asv::core {
namespace {

using test::Points;

TEST(Cost, IsTheSumOfAllMoves) {
    Path path(2);
    EXPECT_EQ(cost(path), 0);
    path.push_back(Points{{0, 0}, {1, 0}});
    EXPECT_EQ(cost(path), 0);
    path.push_back(Points{{3, 4}, {1, 0}});
    path.push_back(Points{{3, 4}, {1, 2}});
    EXPECT_EQ(cost(path), 7);
}

TEST(Cost, LosesNothingOverAMillionSteps) {
    Path path(1);
    for (int i = 0; i <= 1'000'000; ++i) path.push_back(Points{{i % 2 == 0 ? 0.0 : 0.1, 0}});
    EXPECT_DOUBLE_EQ(cost(path), 1e5);
}

}  // namespace
}  // namespace asv::core
