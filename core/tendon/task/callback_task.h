#pragma once

#include <tendon/task/task.h>

#include <mutex>
#include <string>

namespace tendon {

/// A task whose cycles are made by a thread of somebody else: the callback of a driver, a loop of
/// the program.
///
/// Startup() and Cleanup() run in the thread that starts and stops it, or in the driver's if that
/// comes first, and never during a cycle: the driver is usually told of the callback in the one and
/// forgets it in the other.
class CallbackTask : public Task {
 public:
  /// Makes a cycle, in the calling thread; false, and nothing has happened, where the task is not
  /// active. One thread at a time: another one that comes meanwhile is turned away. Never waits.
  bool Cycle() { return CycleDue(SteadyTime::min()); }

 protected:
  explicit CallbackTask(std::string name) : Task(std::move(name)) {}

  /// The same for a cycle that was due at `due`.
  bool CycleDue(SteadyTime due);
  /// Cycles that its driver has skipped. In the thread that makes the cycles.
  void SkipCycles(std::uint64_t cycles);

  Result<void> Launch() override;
  void ServeWaiting() override;

 private:
  std::mutex driving_;  // held during cycles and while orders are obeyed; nobody waits for it
};

}  // namespace tendon
