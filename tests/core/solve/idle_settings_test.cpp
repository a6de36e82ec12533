#include "core/solve/idle_settings.hpp"

#include <gtest/gtest.h>

namespace asv::core {
namespace {

TEST(IdleSettings, WhatIsForChainsDoesNothingForOthers) {
    const Planner planner = planner_named("auto");
    EXPECT_EQ(why_without_effect(planner, "slide-step", BodyKind::chain), "");
    EXPECT_EQ(why_without_effect(planner, "slide-step", BodyKind::arm),
              "it is for chains, and the body is an arm");
    EXPECT_EQ(why_without_effect(planner_named("rrt-connect"), "ladder", BodyKind::point),
              "it is for chains, and the body is a point");
    EXPECT_EQ(why_without_effect(planner_named("rrt-connect"), "goal-bias", BodyKind::point), "");
}

TEST(IdleSettings, WhatBelongsToASwitchNeedsIt) {
    Planner planner = planner_named("rrt-connect");
    EXPECT_EQ(why_without_effect(planner, "swap-steps", BodyKind::chain), "swap-limiter is off");
    set(planner, "swap-limiter", "on");
    EXPECT_EQ(why_without_effect(planner, "swap-steps", BodyKind::chain), "");
}

TEST(IdleSettings, SingleStepsAndWholeMotionsHaveTheirOwn) {
    Planner planner = planner_named("rrt-connect");
    set(planner, "swap-limiter", "on");
    for (const char* of_steps : {"extend-step", "extend-nodes"})
        EXPECT_EQ(why_without_effect(planner, of_steps, BodyKind::chain), "extend is whole");
    for (const char* of_motions : {"enlarge", "enlarge-tries", "ladder", "step", "swap-step"})
        EXPECT_EQ(why_without_effect(planner, of_motions, BodyKind::chain), "");
    set(planner, "extend", "steps");
    for (const char* of_steps : {"extend-step", "extend-nodes", "swap-steps"})
        EXPECT_EQ(why_without_effect(planner, of_steps, BodyKind::chain), "");
    for (const char* of_motions : {"enlarge", "enlarge-tries", "ladder", "step", "swap-step"})
        EXPECT_EQ(why_without_effect(planner, of_motions, BodyKind::chain), "extend is steps");
}

TEST(IdleSettings, WhatBelongsToASamplerNeedsThatSampler) {
    Planner planner = planner_named("rrt");
    EXPECT_NE(why_without_effect(planner, "sigma", BodyKind::chain), "");
    EXPECT_NE(why_without_effect(planner, "mix-uniform", BodyKind::chain), "");
    set(planner, "sampler", "mix");
    set(planner, "mix-gaussian", "1");
    EXPECT_EQ(why_without_effect(planner, "sigma", BodyKind::chain), "");
    EXPECT_EQ(why_without_effect(planner, "mix-uniform", BodyKind::chain), "");
    EXPECT_NE(why_without_effect(planner, "grid-cells", BodyKind::chain), "");
}

}  // namespace
}  // namespace asv::core
