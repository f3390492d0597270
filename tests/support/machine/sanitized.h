#pragma once

// Weak symbols: their address is null if the program is linked without this sanitizer. Macros of
// the compiler do not tell, because a test may be compiled without the sanitizer that it is linked
// with. NOLINTBEGIN(bugprone-reserved-identifier)
extern "C" {
[[gnu::weak]] void __asan_init();
[[gnu::weak]] void __tsan_init();
}
// NOLINTEND(bugprone-reserved-identifier)

namespace tendon::test {

/// True if a sanitizer slows this program and its child programs several times.
inline bool IsSanitized() { return &__asan_init != nullptr || &__tsan_init != nullptr; }

}  // namespace tendon::test
