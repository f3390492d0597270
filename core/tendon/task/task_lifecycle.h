#pragma once

#include <tendon/task/task.h>

#include <memory>

namespace tendon {

/// The work of a task's thread between two cycles: it executes orders for the task and for the
/// tasks that run after it (its followers). This class is separate from Task, so that these names
/// are not visible in the classes of authors.
class TaskLifecycle {
 public:
  /// Executes the orders for the task and for its followers.
  static void ExecuteOrders(Task& task);
  /// Ends a task because its leader has ended.
  static void EndWithLeader(Task& task);
  /// Unbinds the task and its followers from their thread until the next cycle.
  static void Unbind(Task& task);

  template <typename Action>
  static void ForEachFollower(Task& task, Action action) {
    const GuardedPointer<TaskFollowers>::Call call(task.followers_);
    if (call.get() == nullptr) return;
    for (Task* follower : *call.get()) action(*follower);
  }

  /// Returns the time at which the next effect of a command expires, for the task and its
  /// followers.
  [[nodiscard]] static SteadyTime NextExpiry(Task& task);

  /// Wakes the thread that makes the task's cycles, so that it executes orders. Any thread.
  static void WakeThread(Task& task);

  // For managers.

  /// Makes `task` a follower of `leader`. `task` must be at rest. The leader uses its new list of
  /// followers from the next time that it reads the list.
  static void AddFollower(Task& leader, Task& task);
  /// Removes `task` from the followers of `leader`. Fails with kTimeout if a cycle of `leader` that
  /// may use the task has not ended by `deadline`; then nothing is changed.
  static Result<void> RemoveFollower(Task& leader, Task& task, SteadyTime deadline);
  static void SetLeader(Task& task, Task* leader);
  /// Returns the first task in the chain of leaders. Its thread makes the cycles of all these
  /// tasks.
  static Task& RootOf(Task& task) {
    Task* const leader = task.leader_.Get();
    return leader == nullptr ? task : RootOf(*leader);
  }

 private:
  static bool Report(Task& task, bool (Task::*report)());
  static void EnterFaultFromOutside(Task& task);
  static void Begin(Task& task);
  static void BecomeActive(Task& task);
  static void Suspend(Task& task);
  static void Continue(Task& task);
  static void Finish(Task& task);
};

}  // namespace tendon
