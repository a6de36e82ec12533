#include "core/space/sampling/passage_points.hpp"

#include <set>
#include <vector>

#include "tests/kit/sampling_field.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using test::for_seeds;

constexpr Box unit_square{{0, 0}, {1, 1}};

TEST(PassagePoints, LieInTheDoorFarMoreOftenThanByChance) {
    const std::vector<Box> boxes{{{0.45, -1}, {0.55, 0.45}}, {{0.45, 0.55}, {0.55, 2}}};
    const ObstacleField field(boxes);
    const Box door{{0.45, 0.45}, {0.55, 0.55}};
    std::size_t found = 0, in_door = 0;
    for_seeds(2000, [&](Rng& rng) {
        const auto point = passage_point(field, unit_square, rng);
        if (!point) return;
        ++found;
        ASSERT_FALSE(field.contains(*point));
        ASSERT_TRUE(geometry::contains(unit_square, *point));
        in_door += geometry::contains(door, *point);
    });
    EXPECT_GE(found, 300U);
    // The door is a hundredth of the field.
    EXPECT_GE(in_door, found / 5);
}

TEST(PassagePoints, AnOpenFieldHasNone) {
    Rng rng(1);
    EXPECT_FALSE(passage_point(ObstacleField({}), unit_square, rng));
}

TEST(FreePoints, AreFreeAndEverywhere) {
    const ObstacleField field(test::box_in_the_middle());
    std::set<int> places;
    for_seeds(300, [&](Rng& rng) {
        const auto point = free_point(field, unit_square, rng);
        ASSERT_TRUE(point);
        ASSERT_FALSE(field.contains(*point));
        places.insert(static_cast<int>(point->x * 4) * 4 + static_cast<int>(point->y * 4));
    });
    EXPECT_EQ(places.size(), 16U);
    const std::vector<Box> everywhere{unit_square};
    Rng rng(1);
    EXPECT_FALSE(free_point(ObstacleField(everywhere), unit_square, rng));
}

}  // namespace
}  // namespace asv::core
