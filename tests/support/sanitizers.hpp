// Whether this build carries the address or the thread sanitizer, whose stack frames are several times larger.
#pragma once

namespace waymark::testing {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif
#else
inline constexpr bool sanitized = false;
#endif

// The thread sanitizer hands a signal on when the thread makes the next call that it sees. A thread that waits inside a
// library which is not instrumented makes none, so Ctrl-C is not noticed there.
#if defined(__SANITIZE_THREAD__)
inline constexpr bool signals_wait = true;
#elif defined(__has_feature)
#if __has_feature(thread_sanitizer)
inline constexpr bool signals_wait = true;
#else
inline constexpr bool signals_wait = false;
#endif
#else
inline constexpr bool signals_wait = false;
#endif

// How often a random test tries: a tenth of it under sanitizers, where everything is slow.
constexpr int scaled(int n) { return sanitized ? (n + 9) / 10 : n; }

}  // namespace waymark::testing
