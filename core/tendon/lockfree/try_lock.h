#pragma once

#include <tendon/lockfree/atomics.h>

#include <atomic>

namespace tendon {

/// A lock without waiting: one thread at a time holds it, and TryTake() fails for the others.
/// Wait-free; one locked instruction.
template <typename Atomics = StdAtomics>
class TryLock {
 public:
  /// Takes the lock. Returns false if another thread holds it.
  [[nodiscard]] bool TryTake() noexcept {
    return !taken_.exchange(true, std::memory_order_acquire);  // pairs with (A)
  }
  /// Releases the lock. Called by the thread whose TryTake() succeeded.
  void Return() noexcept { taken_.store(false, std::memory_order_release); }  // (A)

  /// Takes the lock if it is free; the destructor releases it.
  class [[nodiscard]] Hold {
   public:
    explicit Hold(TryLock& lease) noexcept : lease_(lease.TryTake() ? &lease : nullptr) {}
    ~Hold() {
      if (lease_ != nullptr) lease_->Return();
    }
    Hold(const Hold&) = delete;
    Hold& operator=(const Hold&) = delete;

    explicit operator bool() const noexcept { return lease_ != nullptr; }

   private:
    TryLock* lease_;
  };

 private:
  typename Atomics::template Atomic<bool> taken_{false};
};

}  // namespace tendon
