#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tendon {

/// The memory of one simulated execution, as C++ allows it to behave: each atomic keeps every value
/// it ever had, and a thread may read any that is not older than what it already knows of. What a
/// thread knows is its view; release and acquire hand views from thread to thread, fences as well.
/// (What it cannot show: a load that reads a store which comes later in the execution.)
class MemoryModel {
 public:
  static constexpr std::size_t kMaxThreads = 4;  // with the one that sets up
  using Thread = std::size_t;
  using Location = std::size_t;

  Location AddAtomic(Thread thread, std::uint64_t value);
  Location AddPlain();

  /// Number of values a load by `thread` may give, the newest first.
  [[nodiscard]] std::size_t Choices(Thread thread, Location location) const;
  /// A sequentially consistent load has its fence before the choice.
  std::uint64_t Load(Thread thread, Location location, std::memory_order order, std::size_t choice);
  void Store(Thread thread, Location location, std::uint64_t value, std::memory_order order);
  /// Read-modify-write: reads the newest value and stores `value(old)` right after it.
  template <typename Change>
  std::uint64_t Modify(Thread thread, Location location, std::memory_order order, Change change) {
    const std::uint64_t old = Load(thread, location, order, 0);
    const View inherited = atomics_[location].back().view;  // a release sequence goes on
    Store(thread, location, change(old), order);
    atomics_[location].back().view.Join(inherited);
    return old;
  }
  void Fence(Thread thread, std::memory_order order);
  /// A full fence in every thread at once.
  void ProcessBarrier();

  /// Accesses to memory that is not atomic; false when they race with one of another thread.
  [[nodiscard]] bool ReadPlain(Thread thread, Location location);
  [[nodiscard]] bool WritePlain(Thread thread, Location location);

  /// `child` begins with, or `parent` continues with, what the other knows.
  void Fork(Thread parent, Thread child);
  void Join(Thread parent, Thread child);

  [[nodiscard]] std::uint64_t Newest(Location location) const;

 private:
  /// For each atomic the oldest value that may still be read; for each thread how many of its
  /// plain accesses have happened before.
  struct View {
    std::vector<std::uint32_t> oldest;
    std::array<std::uint32_t, kMaxThreads> clock{};

    void Join(const View& other);
    [[nodiscard]] std::uint32_t Oldest(Location location) const;
    void See(Location location, std::size_t index);
  };
  struct Value {
    std::uint64_t bits = 0;
    View view;  // what a thread learns that reads it and acquires
  };
  struct ThreadState {
    View current;
    View read;      // from relaxed loads: known after an acquire fence
    View released;  // at the last release fence: handed on by relaxed stores
  };
  struct Plain {
    std::array<std::uint32_t, kMaxThreads> reads{};
    std::array<std::uint32_t, kMaxThreads> writes{};
  };

  std::vector<std::vector<Value>> atomics_;
  std::vector<Plain> plains_;
  std::array<ThreadState, kMaxThreads> threads_;
  View total_order_;  // of sequentially consistent fences
};

}  // namespace tendon
