#include "geometry/simd/instruction_set.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <stdexcept>

#include <gtest/gtest.h>

#include "geometry/simd/dispatch.hpp"
#include "tests/kit/geometry/forced_target.hpp"

namespace asv::geometry::simd {
namespace {

TEST(InstructionSet, TheBestIsUsedUntilAnotherIsAskedFor) {
    ASSERT_FALSE(instruction_sets().empty());
    EXPECT_EQ(instruction_set(), instruction_sets().front());
    {
        const test::ForcedTarget forced(instruction_sets().back());
        EXPECT_EQ(instruction_set(), instruction_sets().back());
    }
    EXPECT_EQ(instruction_set(), instruction_sets().front());
}

TEST(InstructionSet, EachOneHasItsOwnVersionOfAKernel) {
    std::set<std::size_t> versions;
    for (const std::string& name : instruction_sets()) {
        const test::ForcedTarget forced(name);
        versions.insert(chosen_target().GetIndex());
    }
    EXPECT_EQ(versions.size(), instruction_sets().size());
    EXPECT_EQ(versions.count(0), 0U) << "the first entry of a table is no function";
}

TEST(InstructionSet, WhatIsBuiltInIsWhatTheProcessorHas) {
#if defined(__x86_64__)
    const auto has = [](const std::string& name) {
        const auto names = instruction_sets();
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    EXPECT_TRUE(has(hwy::TargetName(HWY_STATIC_TARGET)));
    if ((HWY_TARGETS & HWY_AVX2) != 0) {
        EXPECT_EQ(has("AVX2"), __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"));
    }
    if ((HWY_TARGETS & HWY_AVX3) != 0) {
        EXPECT_EQ(has("AVX3"), __builtin_cpu_supports("avx512bw") != 0);
    }
#endif
}

TEST(InstructionSet, AnUnknownOneIsAnErrorAndChangesNothing) {
    const std::string before = instruction_set();
    for (const char* name : {"MMX", "", "avx2"}) {
        EXPECT_THROW(use_instruction_set(name), std::invalid_argument) << name;
        EXPECT_EQ(instruction_set(), before) << name;
    }
}

TEST(InstructionSet, TheEnvironmentNamesOne) {
    const std::string least = instruction_sets().back();
    ::setenv("ASV_SIMD", least.c_str(), 1);
    use_instruction_set_of_environment();
    EXPECT_EQ(instruction_set(), least);
    use_best_instruction_set();

    ::setenv("ASV_SIMD", "MMX", 1);
    EXPECT_THROW(use_instruction_set_of_environment(), std::invalid_argument);
    ::setenv("ASV_SIMD", "", 1);
    use_instruction_set_of_environment();
    ::unsetenv("ASV_SIMD");
    use_instruction_set_of_environment();
    EXPECT_EQ(instruction_set(), instruction_sets().front());
}

}  // namespace
}  // namespace asv::geometry::simd
