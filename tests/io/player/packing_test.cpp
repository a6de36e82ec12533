#include "io/player/packing.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/search/rng.hpp"

namespace asv::io {
namespace {

TEST(Packing, Base64HasTheVectorsOfRfc4648) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64(std::string("\xFB\xFF\xFE\x00", 4)), "+//+AA==");
}

TEST(Packing, ATableComesBackToHalfAUnit) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        core::Rng random(seed);
        const double size = std::pow(10, 8 * random.normal());
        const std::size_t columns = 1 + seed % 5;
        std::vector<double> numbers(columns * (seed % 7) * 11);
        for (double& number : numbers) number = size * random.normal();
        const PackedTable table = pack_table(numbers, columns);
        const auto back = unpack_table(table, numbers.size() / columns, columns);
        double greatest = 1;
        for (const double number : numbers) greatest = std::max(greatest, std::abs(number));
        EXPECT_NEAR(table.unit, 1e-10 * greatest, 1e-22 * greatest);
        ASSERT_EQ(back.size(), numbers.size());
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            ASSERT_NEAR(back[i], numbers[i], 0.5000001 * table.unit) << "seed " << seed;
        }
    }
}

TEST(Packing, TakesTheGreatestNumbersThereAre) {
    const std::vector<double> numbers{1.7e308, -1.7e308, 1.7e308, -1.7e308, 0};
    const auto back = unpack_table(pack_table(numbers, 1), 5, 1);
    for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(back[i] / 1.7e308, numbers[i] / 1.7e308, 1e-9);
}

TEST(Packing, RejectsATextOfAnotherShape) {
    const PackedTable table = pack_table(std::vector<double>{1, 2, 3, 4}, 2);
    EXPECT_THROW(unpack_table(table, 3, 2), std::invalid_argument);
    EXPECT_THROW(unpack_table(table, 1, 2), std::invalid_argument);
    EXPECT_THROW(unpack_table({1, "!"}, 1, 1), std::invalid_argument);
}

}  // namespace
}  // namespace asv::io
