#pragma once

#include <tendon/task/task.h>

#include <cstdint>
#include <mutex>
#include <string>
#include <utility>

namespace tendon {

/// A task whose cycles run in a thread that the task does not own: in a callback of a driver, or in
/// a loop of the program.
///
/// Startup() and Cleanup() run in the thread that starts or stops the task, or in the driver's
/// thread if that makes a cycle first. They never run during a cycle. Usually Startup() registers
/// the callback with the driver, and Cleanup() removes the callback.
class CallbackTask : public Task {
 public:
  /// Makes a cycle in the calling thread. Returns false and does nothing if the task is not active
  /// or another thread is making a cycle. Never blocks.
  bool Cycle() { return CycleDue(SteadyTime::min()); }

 protected:
  explicit CallbackTask(std::string name) : Task(std::move(name)) {}

  /// Makes a cycle that was due at `due`. The time is used for the statistics of the task.
  bool CycleDue(SteadyTime due);
  /// Counts cycles that the driver has skipped. Must be called in the thread that makes the cycles.
  void SkipCycles(std::uint64_t cycles);

  Result<void> Launch() override;
  void ServeWaiting() override;

 private:
  std::mutex driving_;  // held during cycles and orders; only locked with try_lock
};

}  // namespace tendon
