#pragma once

#include <tendon/lockfree/atomics.h>

#include <array>
#include <atomic>
#include <cstdint>

namespace tendon {

/// Passes the newest value from one thread to another. The reader never gets a partial value, and a
/// newer value replaces an older one. Values are assigned, so that dynamic types keep their memory.
///
/// Thread safety: one thread calls Write() and WriteWith(), one other thread calls Take(), and any
/// thread calls is_fresh(). Wait-free.
///
/// A triple buffer: one of three values belongs to the writer and one to the reader. Each side
/// exchanges its own value with the third, the middle one.
template <typename T, typename Atomics = StdAtomics>
class TripleBuffer {
 public:
  /// Stores a value. Returns true if it replaces a value that the reader has not taken.
  bool Write(const T& value) {
    return WriteWith([&value](T& place) { place = value; });
  }
  /// Like Write(), but `write` writes the value in place, over an old value. If `write` throws,
  /// nothing is stored.
  template <typename Writer>
  bool WriteWith(Writer&& write) {
    write(values_[mine_]);
    // (A) publishes the value; (B) gives the writer a value that the reader no longer uses.
    const std::uint32_t old = middle_.exchange(mine_ | kFresh, std::memory_order_acq_rel);
    mine_ = old & kPlace;
    return (old & kFresh) != 0;
  }

  /// Returns the newest value, which is valid until the reader's next Take(). Returns null if the
  /// reader has already taken the newest value.
  T* Take() noexcept {
    if (!is_fresh()) return nullptr;
    // (B) hands the reader's value back; pairs with (A).
    theirs_ = middle_.exchange(theirs_, std::memory_order_acq_rel) & kPlace;
    return &values_[theirs_];
  }

  /// True if a value waits to be taken. Only the writer makes it true, and only the reader makes it
  /// false.
  [[nodiscard]] bool is_fresh() const noexcept {
    return (middle_.load(std::memory_order_relaxed) & kFresh) != 0;  // orders nothing
  }

 private:
  static constexpr std::uint32_t kPlace = 3;
  static constexpr std::uint32_t kFresh = 4;

  std::array<T, 3> values_{};
  std::uint32_t mine_ = 0;    // index of the writer's value
  std::uint32_t theirs_ = 1;  // index of the reader's value
  typename Atomics::template Atomic<std::uint32_t> middle_{2};
};

}  // namespace tendon
