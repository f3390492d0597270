#pragma once

#include <tendon/lockfree/atomics.h>

#include <atomic>
#include <type_traits>

namespace tendon {

/// A small value that threads set and read. A Get() that sees a value also sees everything written
/// before its Set(). Wait-free.
template <typename T, typename Atomics = StdAtomics>
requires std::is_trivially_copyable_v<T>
class Published {
 public:
  explicit Published(T value = {}) : value_(value) {}

  void Set(T value) noexcept { value_.store(value, std::memory_order_release); }  // (A)
  [[nodiscard]] T Get() const noexcept {
    return value_.load(std::memory_order_acquire);  // pairs with (A)
  }

 private:
  typename Atomics::template Atomic<T> value_;
};

using Flag = Published<bool>;

}  // namespace tendon
