#include "core/shorten/band/block_tridiagonal.hpp"

#include <vector>

#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using test::for_seeds;

TEST(BlockTridiagonal, SolvesWhatMultiplyingMade) {
    for_seeds(50, [](Rng& rng) {
        const std::size_t blocks = 1 + rng.below(6), size = 1 + rng.below(9), all = blocks * size;
        // A' A with A block bidiagonal is block tridiagonal and positive definite.
        std::vector<double> a(all * all, 0.0), matrix(all * all, 0.0);
        for (std::size_t r = 0; r < all; ++r)
            for (std::size_t c = 0; c < all; ++c) {
                const std::size_t row = r / size, column = c / size;
                if (row == column || row + 1 == column) a[r * all + c] = rng.uniform(-1, 1);
                if (r == c) a[r * all + c] += 3;
            }
        for (std::size_t r = 0; r < all; ++r)
            for (std::size_t c = 0; c < all; ++c)
                for (std::size_t k = 0; k < all; ++k)
                    matrix[r * all + c] += a[k * all + r] * a[k * all + c];
        BlockTridiagonal system;
        system.reset(blocks, size);
        for (std::size_t b = 0; b < blocks; ++b)
            for (std::size_t r = 0; r < size; ++r)
                for (std::size_t c = 0; c < size; ++c) {
                    const std::size_t at = (b * size + r) * all + b * size + c;
                    system.diagonal(b)[c * size + r] = matrix[at];
                    if (b + 1 < blocks) system.upper(b)[c * size + r] = matrix[at + size];
                }
        std::vector<double> expected(all), vector(all, 0.0);
        for (double& value : expected) value = rng.uniform(-1, 1);
        for (std::size_t r = 0; r < all; ++r)
            for (std::size_t c = 0; c < all; ++c) vector[r] += matrix[r * all + c] * expected[c];
        ASSERT_TRUE(system.solve(vector));
        for (std::size_t i = 0; i < all; ++i) ASSERT_NEAR(vector[i], expected[i], 1e-9);
    });
}

TEST(BlockTridiagonal, SaysWhatIsNotPositiveDefinite) {
    BlockTridiagonal system;
    system.reset(2, 1);
    system.diagonal(0)[0] = 1;
    system.upper(0)[0] = 2;
    system.diagonal(1)[0] = 1;
    std::vector<double> vector{1, 1};
    EXPECT_FALSE(system.solve(vector));
}

}  // namespace
}  // namespace asv::core
