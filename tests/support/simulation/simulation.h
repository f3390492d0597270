#pragma once

#include <support/simulation/memory_model.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

/// An interleaving simulator for lock-free code. It runs a scenario of two or three small threads
/// repeatedly. Each execution has another order of steps, or loads return other values that the
/// memory model allows. The simulator ends when all possibilities have been tried. Code under test
/// uses SimulatedAtomics.
namespace tendon::simulation {

/// The limits of an exploration. Small limits find nearly every fault.
struct Limits {
  int preemptions = 2;                 ///< switches away from a thread that could continue
  int stale_reads = 2;                 ///< loads that return an older value than the newest
  std::size_t executions = 1'000'000;  ///< the exploration ends after this number
};

struct Report {
  std::size_t executions = 0;
  bool is_complete = false;  ///< all executions within the limits were tried
  std::string failure;       ///< message and steps of the first failed execution; otherwise empty
};

/// The threads of one execution. They own the shared objects, new for each execution.
class Scenario {
 public:
  void Thread(std::function<void()> body) { threads.push_back(std::move(body)); }
  /// Runs after all threads have ended.
  void Finally(std::function<void()> body) { finally = std::move(body); }

  std::vector<std::function<void()>> threads;
  std::function<void()> finally;
};

/// Runs the scenario until all executions are tried. Stops at the first failure: a Check(), a race
/// on plain memory, or a deadlock.
Report Explore(const std::function<void(Scenario&)>& build, Limits limits = {});

/// Fails the execution with `sentence` if `condition` is false. Call it in a thread of a scenario.
void Check(bool condition, std::string_view sentence);

/// The number of the thread that builds the scenario and runs `finally`. The other threads count
/// from 1.
inline constexpr std::size_t kSetUp = 0;
/// Returns the number of the running thread. Call it in a scenario.
std::size_t RunningThread();

// The primitives of SimulatedAtomics: operations of the running thread.
MemoryModel::Location AddAtomic(std::uint64_t value);
MemoryModel::Location AddPlain();
std::uint64_t Load(MemoryModel::Location location, std::memory_order order);
void Store(MemoryModel::Location location, std::uint64_t value, std::memory_order order);
std::uint64_t Modify(MemoryModel::Location location, std::memory_order order,
                     const std::function<std::uint64_t(std::uint64_t)>& change);
void Fence(std::memory_order order);
void ProcessBarrier();
void ReadPlain(MemoryModel::Location location);
void WritePlain(MemoryModel::Location location);
/// Waits until another thread has stored a value that this thread has not seen.
void AwaitAnyStore();
void Sleep(MemoryModel::Location location, std::uint64_t expected);
void Wake(MemoryModel::Location location);

}  // namespace tendon::simulation
