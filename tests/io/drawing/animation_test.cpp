#include "io/drawing/animation.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

#include "tests/kit/files/drawing_samples.hpp"

namespace asv::io {
namespace {

TEST(Animation, ShowsTheBodyElsewhereInEveryPicture) {
    const Exhibit exhibit =
        make_exhibit(test::sample(5, {{0.1, 0.3}, {0.7, 0.3}}, test::two_walls()));
    const Animation animation(exhibit, Theme::light, 4);
    ASSERT_EQ(animation.size(), 4);
    std::set<std::string> pictures;
    for (std::size_t i = 0; i < animation.size(); ++i) {
        const std::string picture = animation.picture(i);
        EXPECT_TRUE(picture.starts_with("\x89PNG"));
        pictures.insert(picture);
    }
    EXPECT_EQ(pictures.size(), 4);
}

TEST(Animation, EndsWithTheGoalHoweverManyPicturesThereAre) {
    const Exhibit exhibit = make_exhibit(test::sample(4, {{0.1, 0.3}, {0.3, 0.3}}, {}));
    const Animation few(exhibit, Theme::light, 2), many(exhibit, Theme::light, 9);
    EXPECT_EQ(few.picture(0), many.picture(0));
    EXPECT_EQ(few.picture(1), many.picture(8));
    EXPECT_EQ(Animation(exhibit, Theme::light, 3).picture(1), many.picture(4));
}

TEST(Animation, ShowsAPathThatDoesNotMove) {
    const Exhibit exhibit = make_exhibit(test::sample(3, {{0.2, 0.3}}, {}));
    EXPECT_EQ(Animation(exhibit, Theme::dark, 2).picture(0),
              Animation(exhibit, Theme::dark, 2).picture(1));
}

}  // namespace
}  // namespace asv::io
