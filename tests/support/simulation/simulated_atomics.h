#pragma once

#include <support/simulation/simulation.h>
#include <tendon/base/clock.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <cstring>

namespace tendon {

/// The atomics policy with which lock-free classes run in a simulation. Time does not advance, so
/// no wait times out.
struct SimulatedAtomics {
  template <typename T>
  class Atomic {
   public:
    Atomic() : Atomic(T{}) {}
    Atomic(T value) : location_(simulation::AddAtomic(Bits(value))) {}  // NOLINT
    Atomic(const Atomic&) = delete;
    Atomic& operator=(const Atomic&) = delete;

    T load(std::memory_order order = std::memory_order_seq_cst) const noexcept {
      return Value(simulation::Load(location_, order));
    }
    void store(T value, std::memory_order order = std::memory_order_seq_cst) noexcept {
      simulation::Store(location_, Bits(value), order);
    }
    T exchange(T value, std::memory_order order = std::memory_order_seq_cst) noexcept {
      return Value(simulation::Modify(location_, order, [&](auto) { return Bits(value); }));
    }
    T fetch_add(T n, std::memory_order order = std::memory_order_seq_cst) noexcept {
      return Value(simulation::Modify(
          location_, order, [&](auto old) { return Bits(static_cast<T>(Value(old) + n)); }));
    }
    T fetch_sub(T n, std::memory_order order = std::memory_order_seq_cst) noexcept {
      return Value(simulation::Modify(
          location_, order, [&](auto old) { return Bits(static_cast<T>(Value(old) - n)); }));
    }
    bool compare_exchange_strong(T& expected, T value,
                                 std::memory_order order = std::memory_order_seq_cst) noexcept {
      const std::uint64_t wanted = Bits(expected);
      const std::uint64_t found = simulation::Modify(
          location_, order, [&](auto old) { return old == wanted ? Bits(value) : old; });
      expected = Value(found);
      return found == wanted;
    }
    bool compare_exchange_weak(T& expected, T value,
                               std::memory_order order = std::memory_order_seq_cst) noexcept {
      return compare_exchange_strong(expected, value, order);
    }
    [[nodiscard]] MemoryModel::Location location() const noexcept { return location_; }

   private:
    static_assert(sizeof(T) <= sizeof(std::uint64_t));

    static std::uint64_t Bits(T value) {
      std::uint64_t bits = 0;
      std::memcpy(&bits, &value, sizeof(T));
      return bits;
    }
    static T Value(std::uint64_t bits) {
      T value{};
      std::memcpy(static_cast<void*>(&value), &bits, sizeof(T));
      return value;
    }

    MemoryModel::Location location_;
  };

  static void Fence(std::memory_order order) noexcept { simulation::Fence(order); }
  static void CompilerFence() noexcept {}
  static void ProcessBarrier() noexcept { simulation::ProcessBarrier(); }
  static void Sleep(const Atomic<std::uint32_t>& word, std::uint32_t expected,
                    std::chrono::nanoseconds /*timeout*/) noexcept {
    simulation::Sleep(word.location(), expected);
  }
  static void Wake(const Atomic<std::uint32_t>& word) noexcept {
    simulation::Wake(word.location());
  }
  static void Pause(unsigned /*looks*/) noexcept { simulation::AwaitAnyStore(); }
  static SteadyTime Now() noexcept { return {}; }
};

/// Plain memory in a simulation. A data race makes the execution fail.
template <typename T>
class Plain {
 public:
  explicit Plain(T value = {}) : value_(value), location_(simulation::AddPlain()) {}

  [[nodiscard]] T Read() const {
    simulation::ReadPlain(location_);
    return value_;
  }
  void Write(T value) {
    simulation::WritePlain(location_);
    value_ = value;
  }

 private:
  T value_;
  MemoryModel::Location location_;
};

}  // namespace tendon
