#pragma once

#include <support/simulation/simulated_atomics.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <type_traits>

/// Lock-free classes with one fault. They are compiled from their own source, with a policy that
/// changes one step.
namespace tendon::seeded {

enum class Step { kLoad, kStore, kAdd, kSubtract, kExchange, kFence, kProcessBarrier };

/// One step of a class, as a fault sees it.
struct Access {
  Step step = Step::kLoad;
  std::size_t thread = 0;              ///< its number in the scenario, from 1 on
  MemoryModel::Location location = 0;  ///< atomics are numbered from 0, in the order of creation
  std::size_t loads_since_fence = 0;   ///< number of loads since the last fence in this thread
  std::size_t fences = 0;              ///< number of fences in this thread before this step
  std::memory_order order = std::memory_order_seq_cst;
  bool is_left_out = false;  ///< true: the fence or barrier is skipped
};

struct Fault {
  std::string name;
  std::function<void(Access&)> weaken;  ///< changes the memory order, or skips the step
  /// Changes the result of a load, so that the check of this result always passes.
  std::function<void(const Access&, std::uint64_t& value)> forge;

  friend std::ostream& operator<<(std::ostream& out, const Fault& fault) {
    return out << fault.name;
  }
};

/// Explores the scenario with the fault in every class under SeededAtomics.
simulation::Report Explore(const Fault& fault,
                           const std::function<void(simulation::Scenario&)>& build);

/// The parts of the policy. Begin() begins a step and applies the fault to it; the second function
/// changes the result of a load.
Access Begin(Step step, std::memory_order order, MemoryModel::Location location = 0);
void Forge(const Access& access, std::uint64_t& value);

struct SeededAtomics : SimulatedAtomics {
  template <typename T>
  struct Atomic : SimulatedAtomics::Atomic<T> {
    using Base = SimulatedAtomics::Atomic<T>;
    using Base::Base;

    T load(std::memory_order order) const noexcept {
      const Access access = Begin(Step::kLoad, order, this->location());
      const T value = Base::load(access.order);
      if constexpr (std::is_integral_v<T>) {
        auto bits = static_cast<std::uint64_t>(value);
        Forge(access, bits);
        return static_cast<T>(bits);
      } else {
        return value;
      }
    }
    void store(T value, std::memory_order order) noexcept {
      Base::store(value, Begin(Step::kStore, order, this->location()).order);
    }
    T exchange(T value, std::memory_order order) noexcept {
      return Base::exchange(value, Begin(Step::kExchange, order, this->location()).order);
    }
    T fetch_add(T n, std::memory_order order) noexcept {
      return Base::fetch_add(n, Begin(Step::kAdd, order, this->location()).order);
    }
    T fetch_sub(T n, std::memory_order order) noexcept {
      return Base::fetch_sub(n, Begin(Step::kSubtract, order, this->location()).order);
    }
  };

  static void Fence(std::memory_order order) noexcept {
    const Access access = Begin(Step::kFence, order);
    if (!access.is_left_out) SimulatedAtomics::Fence(access.order);
  }
  static void ProcessBarrier() noexcept {
    const Access access = Begin(Step::kProcessBarrier, std::memory_order_seq_cst);
    if (!access.is_left_out) SimulatedAtomics::ProcessBarrier();
  }
};

}  // namespace tendon::seeded
