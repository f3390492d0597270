#pragma once

#include <tendon/lockfree/atomics.h>

#include <atomic>
#include <cstdint>
#include <limits>

namespace tendon {

/// So many of something may be taken at a time, by any threads. Wait-free; without a limit it costs
/// nothing. Says nothing about the order of other data.
template <typename Atomics = StdAtomics>
class Budget {
 public:
  static constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

  explicit Budget(std::uint64_t most = kNoLimit) : most_(most) {}

  /// Takes `n` where no more than the most are taken then, or they are all that is taken: one alone
  /// may be larger. Where others are just refused, it may be refused with them.
  [[nodiscard]] bool Take(std::uint64_t n) noexcept {
    if (most_ == kNoLimit) return true;
    const std::uint64_t before = taken_.fetch_add(n, std::memory_order_relaxed);
    if (before == 0 || before + n <= most_) return true;
    Give(n);
    return false;
  }
  /// Gives back what was taken.
  void Give(std::uint64_t n) noexcept {
    if (most_ != kNoLimit) taken_.fetch_sub(n, std::memory_order_relaxed);
  }

 private:
  const std::uint64_t most_;
  typename Atomics::template Atomic<std::uint64_t> taken_{0};
};

}  // namespace tendon
