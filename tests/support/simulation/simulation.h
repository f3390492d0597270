#pragma once

#include <support/simulation/memory_model.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

/// An interleaving simulator for lock-free code: runs a scenario of two or three small threads
/// again and again, each time in another order and with other values that the memory model allows,
/// until all have been tried. Code under test takes its atomics from SimulatedAtomics.
namespace tendon::simulation {

/// How far an exploration goes. Few of each find nearly every fault.
struct Limits {
  int preemptions = 2;                 ///< switches away from a thread that could have gone on
  int stale_reads = 2;                 ///< loads that give other than the newest value
  std::size_t executions = 1'000'000;  ///< then it gives up
};

struct Report {
  std::size_t executions = 0;
  bool is_complete = false;  ///< all within the limits were tried
  std::string failure;       ///< of the first execution that failed, with its steps; else empty
};

/// One execution's threads. What they share is made anew for each execution and owned by them.
class Scenario {
 public:
  void Thread(std::function<void()> body) { threads.push_back(std::move(body)); }
  /// Runs after all threads have ended.
  void Finally(std::function<void()> body) { finally = std::move(body); }

  std::vector<std::function<void()>> threads;
  std::function<void()> finally;
};

/// Stops at the first failure: a Check(), a race on plain memory, or threads that all wait.
Report Explore(const std::function<void(Scenario&)>& build, Limits limits = {});

/// In a thread of a scenario: the execution fails with `sentence` unless `condition` holds.
void Check(bool condition, std::string_view sentence);

/// The thread that builds the scenario and runs `finally`; the others count from 1.
inline constexpr std::size_t kSetUp = 0;
/// In a scenario: the thread that runs now.
std::size_t RunningThread();

// What SimulatedAtomics is made of: operations of the running thread.
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
/// Until another thread has stored something that this one has not had a chance to see.
void AwaitAnyStore();
void Sleep(MemoryModel::Location location, std::uint64_t expected);
void Wake(MemoryModel::Location location);

}  // namespace tendon::simulation
