#pragma once

#include <tendon/task/task.h>

#include <mutex>
#include <string>

namespace tendon {

/// A task whose cycles run in a foreign thread: a callback of a driver, or a loop of the program.
///
/// Startup() and Cleanup() run in the thread that starts or stops the task, or in the driver's
/// thread if it makes a cycle first, but never during a cycle. Usually Startup() registers the
/// callback with the driver, and Cleanup() removes it.
class CallbackTask : public Task {
 public:
  /// Makes a cycle in the calling thread. Returns false without effect if the task is not active,
  /// or while another thread makes a cycle. Never waits.
  bool Cycle() { return CycleDue(SteadyTime::min()); }

 protected:
  explicit CallbackTask(std::string name) : Task(std::move(name)) {}

  /// The same for a cycle that was due at `due`.
  bool CycleDue(SteadyTime due);
  /// Counts cycles that the driver has skipped. Called in the thread that makes the cycles.
  void SkipCycles(std::uint64_t cycles);

  Result<void> Launch() override;
  void ServeWaiting() override;

 private:
  std::mutex driving_;  // held during cycles and while orders are obeyed; only try_lock
};

}  // namespace tendon
