#pragma once

#include <atomic>
#include <cstdint>

#include <hwy/highway.h>

/// Calls of functions that are compiled once for each instruction set, as HWY_EXPORT and
/// HWY_DYNAMIC_DISPATCH make them, but without Highway's library, of which only headers are used.

namespace asv::geometry::simd {

/// The instruction set that the kernels run on; see instruction_set.hpp.
const hwy::ChosenTarget& chosen_target() noexcept;

}  // namespace asv::geometry::simd

/// The table of a function's versions, in the namespace around HWY_NAMESPACE. Its first entry is
/// for a target that has not been chosen yet, which chosen_target() never is.
#define ASV_SIMD_EXPORT(FUNCTION)                                          \
    constexpr decltype(&HWY_STATIC_DISPATCH(                               \
        FUNCTION)) FUNCTION##OnEachTarget[HWY_MAX_DYNAMIC_TARGETS + 2] = { \
        nullptr, HWY_CHOOSE_TARGET_LIST(FUNCTION), HWY_CHOOSE_FALLBACK(FUNCTION)}

/// The version for the chosen instruction set.
#define ASV_SIMD_DISPATCH(FUNCTION) \
    (*FUNCTION##OnEachTarget[::asv::geometry::simd::chosen_target().GetIndex()])
