#include "core/chain/arm_kinematics.hpp"

#include "tests/kit/chains/arms.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using test::for_seeds;
using test::random_arm;
using test::scaled;
using test::textbook;

TEST(Arm, ItsPointsAreThoseOfTheTextbook) {
    for_seeds(scaled(500), [](Rng& rng) {
        const PlanarArm arm = random_arm(rng);
        const Point base{rng.uniform(), rng.uniform()};
        const auto points = arm_points(arm, base, arm.start);
        const auto expected = textbook(arm, base, arm.start);
        ASSERT_EQ(points.size(), expected.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_NEAR(points[i].x, expected[i].x, 1e-14);
            EXPECT_NEAR(points[i].y, expected[i].y, 1e-14);
        }
    });
}

}  // namespace
}  // namespace asv::core
