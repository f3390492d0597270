#pragma once

#include <tendon/lockfree/atomics.h>

#include <atomic>
#include <cstdint>
#include <limits>

namespace tendon {

/// Limits the total number of units that all threads hold. Wait-free. A budget without a limit
/// costs nothing. Take() and Give() do not order accesses to other memory.
template <typename Atomics = StdAtomics>
class Budget {
 public:
  static constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

  explicit Budget(std::uint64_t most = kNoLimit) : most_(most) {}

  /// Takes `n` units and returns true if the total stays within the limit. If no units are taken,
  /// any request succeeds, even one above the limit. A request may fail without need while another
  /// thread's request is being refused.
  [[nodiscard]] bool Take(std::uint64_t n) noexcept {
    if (most_ == kNoLimit) return true;
    const std::uint64_t before = taken_.fetch_add(n, std::memory_order_relaxed);
    if (before == 0 || before + n <= most_) return true;
    Give(n);
    return false;
  }
  /// Gives back `n` units that Take() has taken.
  void Give(std::uint64_t n) noexcept {
    if (most_ != kNoLimit) taken_.fetch_sub(n, std::memory_order_relaxed);
  }

 private:
  const std::uint64_t most_;
  typename Atomics::template Atomic<std::uint64_t> taken_{0};
};

}  // namespace tendon
