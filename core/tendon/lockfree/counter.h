#pragma once

#include <tendon/lockfree/atomics.h>

#include <atomic>
#include <cstdint>

namespace tendon {

/// A number that one thread increments and any thread may read. As cheap as a plain variable. It
/// does not order accesses to other memory.
template <typename Atomics = StdAtomics>
class Counter {
 public:
  void Add(std::uint64_t n = 1) noexcept {
    value_.store(value_.load(std::memory_order_relaxed) + n, std::memory_order_relaxed);
  }
  [[nodiscard]] std::uint64_t value() const noexcept {
    return value_.load(std::memory_order_relaxed);
  }

 private:
  typename Atomics::template Atomic<std::uint64_t> value_{0};
};

/// Like Counter, but several threads may increment it. An increment costs one locked instruction.
template <typename Atomics = StdAtomics>
class SharedCounter {
 public:
  void Add(std::uint64_t n = 1) noexcept { value_.fetch_add(n, std::memory_order_relaxed); }
  [[nodiscard]] std::uint64_t value() const noexcept {
    return value_.load(std::memory_order_relaxed);
  }

 private:
  typename Atomics::template Atomic<std::uint64_t> value_{0};
};

}  // namespace tendon
