#include "core/shorten/shortcutter.hpp"

#include <algorithm>

#include "tests/kit/chains/configuration_oracle.hpp"
#include "tests/kit/chains/wandering_path.hpp"
#include "tests/kit/scaled.hpp"
#include "tests/kit/seeds.hpp"

namespace asv::core {
namespace {

using test::for_seeds;
using test::Oracle;
using test::scaled;
using test::Wanderer;
using test::way;

TEST(Shortcutter, KeepsEndsAndValidityAndGains) {
    for_seeds(scaled(15), [](Rng& rng) {
        const std::size_t sizes[] = {1, 3, 7};
        Wanderer wanderer(rng, sizes[rng.below(3)], 4);
        if (wanderer.path.size() < 4 * wanderer.world.chain.dimension()) return;
        Shortcutter shortcutter(wanderer.world.chain, wanderer.path);
        const Bridge straight = [&](auto from, auto to, Configurations& rows) {
            if (!wanderer.checker.valid(from, to)) return false;
            rows.assign(to.begin(), to.end());
            return true;
        };
        for (int i = 0; i < 60; ++i) {
            const double before = shortcutter.cost();
            const Configurations rows = shortcutter.path();
            if (shortcutter.attempt(straight, 0.7, rng)) {
                ASSERT_LT(shortcutter.cost(), before);
            } else {
                ASSERT_EQ(shortcutter.path(), rows);
            }
        }
        wanderer.expect_same_ends(shortcutter.path());
        Oracle(wanderer.world).expect_valid_path(shortcutter.path());
        const double expected = way(wanderer.world.chain, shortcutter.path());
        ASSERT_NEAR(shortcutter.cost(), expected, 2e-3 * expected);
    });
}

TEST(Shortcutter, PartialShortcutsKeepEndsAndValidityAndGain) {
    std::size_t gains = 0;
    for_seeds(std::max<std::size_t>(3, scaled(15)), [&](Rng& rng) {
        const std::size_t sizes[] = {1, 3, 7};
        Wanderer wanderer(rng, sizes[rng.below(3)], 4);
        const std::size_t d = wanderer.world.chain.dimension();
        if (wanderer.path.size() < 4 * d) return;
        Shortcutter shortcutter(wanderer.world.chain, wanderer.path);
        const auto valid = [&](auto from, auto to) { return wanderer.checker.valid(from, to); };
        for (int i = 0; i < 60; ++i) {
            const double before = shortcutter.cost();
            const Configurations rows = shortcutter.path();
            const std::size_t first = rng.below(d - 1), count = first == 0 ? 2 : 1;
            if (shortcutter.attempt_partial(first, count, valid, 0.7, rng)) {
                ++gains;
                ASSERT_LT(shortcutter.cost(), before);
            } else {
                ASSERT_EQ(shortcutter.path(), rows);
            }
        }
        wanderer.expect_same_ends(shortcutter.path());
        Oracle(wanderer.world).expect_valid_path(shortcutter.path());
    });
    EXPECT_GT(gains, 20U);
}

TEST(Shortcutter, DetoursThatCostMoreAreNotTaken) {
    const Chain point(1, 0.05, Anchor::centroid);
    const Configurations bend{0, 0, 1, 0, 1, 1};
    Shortcutter shortcutter(point, bend);
    const Bridge detour = [](auto, auto to, Configurations& rows) {
        rows = {-1, -1, to[0], to[1]};
        return true;
    };
    const Bridge none = [](auto, auto, Configurations&) { return false; };
    Rng rng(1);
    for (int i = 0; i < 100; ++i) {
        EXPECT_FALSE(shortcutter.attempt(detour, 1, rng));
        EXPECT_FALSE(shortcutter.attempt(none, 1, rng));
    }
    EXPECT_EQ(shortcutter.path(), bend);
}

}  // namespace
}  // namespace asv::core
