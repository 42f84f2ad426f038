// Whether this build carries the address sanitizer, whose stack frames are several times larger.
#pragma once

namespace waymark::testing {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif
#else
inline constexpr bool sanitized = false;
#endif

// How often a random test tries: a tenth of it under sanitizers, where everything is slow.
constexpr int scaled(int n) { return sanitized ? (n + 9) / 10 : n; }

}  // namespace waymark::testing
