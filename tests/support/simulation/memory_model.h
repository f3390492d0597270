#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace tendon {

/// The memory of one simulated execution under the C++ memory model. Each atomic keeps all its
/// values. For each atomic, the view of a thread holds the oldest value that the thread may still
/// read. Release, acquire and fences pass views between threads. (Limit: a load never reads a value
/// that is stored later in the execution.)
class MemoryModel {
 public:
  static constexpr std::size_t kMaxThreads = 4;  // including the thread that sets up the scenario
  using Thread = std::size_t;
  using Location = std::size_t;

  Location AddAtomic(Thread thread, std::uint64_t value);
  Location AddPlain();

  /// Returns the number of values that a load by `thread` may return. Choice 0 is the newest value.
  [[nodiscard]] std::size_t Choices(Thread thread, Location location) const;
  /// For a sequentially consistent load, the fence must come before Choices().
  std::uint64_t Load(Thread thread, Location location, std::memory_order order, std::size_t choice);
  void Store(Thread thread, Location location, std::uint64_t value, std::memory_order order);
  /// Read-modify-write: reads the newest value `old` and stores `value(old)` directly after it.
  template <typename Change>
  std::uint64_t Modify(Thread thread, Location location, std::memory_order order, Change change) {
    const std::uint64_t old = Load(thread, location, order, 0);
    // The new value continues a release sequence.
    const View inherited = atomics_[location].back().view;
    Store(thread, location, change(old), order);
    atomics_[location].back().view.Join(inherited);
    return old;
  }
  void Fence(Thread thread, std::memory_order order);
  /// A full fence in every thread at once.
  void ProcessBarrier();

  /// Accesses memory that is not atomic. Returns false if the access races with another thread.
  [[nodiscard]] bool ReadPlain(Thread thread, Location location);
  [[nodiscard]] bool WritePlain(Thread thread, Location location);

  /// Fork() gives `child` the view of `parent`. Join() adds the view of `child` to the view of
  /// `parent`.
  void Fork(Thread parent, Thread child);
  void Join(Thread parent, Thread child);

  [[nodiscard]] std::uint64_t Newest(Location location) const;

 private:
  /// For each atomic, the oldest readable value. For each thread, the number of its plain accesses
  /// that happened before.
  struct View {
    std::vector<std::uint32_t> oldest;
    std::array<std::uint32_t, kMaxThreads> clock{};

    void Join(const View& other);
    [[nodiscard]] std::uint32_t Oldest(Location location) const;
    void See(Location location, std::size_t index);
  };
  struct Value {
    std::uint64_t bits = 0;
    View view;  // the view that an acquiring reader adds
  };
  struct ThreadState {
    View current;
    View read;      // views of relaxed loads; an acquire fence adds them to the view
    View released;  // the view at the last release fence; relaxed stores pass it on
  };
  struct Plain {
    std::array<std::uint32_t, kMaxThreads> reads{};
    std::array<std::uint32_t, kMaxThreads> writes{};
  };

  std::vector<std::vector<Value>> atomics_;
  std::vector<Plain> plains_;
  std::array<ThreadState, kMaxThreads> threads_;
  View total_order_;  // over sequentially consistent fences
};

}  // namespace tendon
