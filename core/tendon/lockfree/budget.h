#pragma once

#include <tendon/lockfree/atomics.h>

#include <atomic>
#include <cstdint>
#include <limits>

namespace tendon {

/// Limits the total number of units that all threads hold. Wait-free; costs nothing without a
/// limit. Does not order other data.
template <typename Atomics = StdAtomics>
class Budget {
 public:
  static constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

  explicit Budget(std::uint64_t most = kNoLimit) : most_(most) {}

  /// Takes `n` units if the total stays within the limit, or if no units are taken, so that a
  /// single large request succeeds. May fail spuriously while another thread's request is being
  /// refused.
  [[nodiscard]] bool Take(std::uint64_t n) noexcept {
    if (most_ == kNoLimit) return true;
    const std::uint64_t before = taken_.fetch_add(n, std::memory_order_relaxed);
    if (before == 0 || before + n <= most_) return true;
    Give(n);
    return false;
  }
  /// Returns units that were taken.
  void Give(std::uint64_t n) noexcept {
    if (most_ != kNoLimit) taken_.fetch_sub(n, std::memory_order_relaxed);
  }

 private:
  const std::uint64_t most_;
  typename Atomics::template Atomic<std::uint64_t> taken_{0};
};

}  // namespace tendon
