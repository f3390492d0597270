#pragma once

#include <support/simulation/simulated_atomics.h>

#include <atomic>

namespace tendon {

/// SimulatedAtomics without one guarantee. A lock-free class that needs the guarantee must fail
/// without it. Otherwise the scenario of the class proves nothing.
template <std::memory_order kOrder>
struct WithoutFence : SimulatedAtomics {
  static void Fence(std::memory_order order) noexcept {
    if (order != kOrder) SimulatedAtomics::Fence(order);
  }
};

struct WithoutProcessBarrier : SimulatedAtomics {
  static void ProcessBarrier() noexcept {}
};

/// Stores do not release.
struct WithoutRelease : SimulatedAtomics {
  template <typename T>
  struct Atomic : SimulatedAtomics::Atomic<T> {
    using SimulatedAtomics::Atomic<T>::Atomic;

    void store(T value, std::memory_order /*order*/) noexcept {
      SimulatedAtomics::Atomic<T>::store(value, std::memory_order_relaxed);
    }
    T exchange(T value, std::memory_order order) noexcept {
      return SimulatedAtomics::Atomic<T>::exchange(
          value, order == std::memory_order_acq_rel ? std::memory_order_acquire : order);
    }
    T fetch_sub(T n, std::memory_order /*order*/) noexcept {
      return SimulatedAtomics::Atomic<T>::fetch_sub(n, std::memory_order_relaxed);
    }
  };
};

/// Loads do not acquire.
struct WithoutAcquire : SimulatedAtomics {
  template <typename T>
  struct Atomic : SimulatedAtomics::Atomic<T> {
    using SimulatedAtomics::Atomic<T>::Atomic;

    T load(std::memory_order /*order*/) const noexcept {
      return SimulatedAtomics::Atomic<T>::load(std::memory_order_relaxed);
    }
    T exchange(T value, std::memory_order order) noexcept {
      return SimulatedAtomics::Atomic<T>::exchange(value, order == std::memory_order_acq_rel
                                                              ? std::memory_order_release
                                                              : std::memory_order_relaxed);
    }
    bool compare_exchange_strong(T& expected, T value, std::memory_order /*order*/) noexcept {
      return SimulatedAtomics::Atomic<T>::compare_exchange_strong(expected, value,
                                                                  std::memory_order_relaxed);
    }
  };
};

}  // namespace tendon
