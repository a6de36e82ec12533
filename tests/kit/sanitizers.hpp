#pragma once

// GCC says by a macro which sanitizer is at work, clang by a feature.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ASV_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define ASV_SANITIZED
#endif
#endif

namespace asv::test {

/// Is a sanitizer at work? It has a malloc of its own, needs terabytes of addresses, and lets
/// nothing be loaded before itself.
#ifdef ASV_SANITIZED
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace asv::test

#undef ASV_SANITIZED
