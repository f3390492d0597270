#pragma once

#include <chrono>

// Weak symbols: their addresses are null if the program is linked without this sanitizer. Macros of
// the compiler would not be reliable, because a test may be compiled without the sanitizer with
// which it is linked. NOLINTBEGIN(bugprone-reserved-identifier)
extern "C" {
[[gnu::weak]] void __asan_init();
[[gnu::weak]] void __tsan_init();
}
// NOLINTEND(bugprone-reserved-identifier)

namespace tendon::test {

/// Returns true if a sanitizer makes this program and its child programs several times slower.
inline bool IsSanitized() { return &__asan_init != nullptr || &__tsan_init != nullptr; }

/// Returns the time limit of a wait. It only limits a failing test, and is not a requirement on
/// speed: a busy machine may need minutes for what takes a second without a sanitizer.
inline std::chrono::seconds LongestWait() { return std::chrono::seconds(IsSanitized() ? 240 : 90); }

}  // namespace tendon::test
