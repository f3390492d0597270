#pragma once

namespace tendon::test {

/// Whether a sanitizer slows this program, and those it starts, several times.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kIsSanitized = true;
#else
inline constexpr bool kIsSanitized = false;
#endif

}  // namespace tendon::test
