#pragma once

#include <tendon/task/task.h>

#include <memory>

namespace tendon {

/// The work between two cycles of the thread that makes a task's cycles: it obeys orders for the
/// task and for the tasks that run after it. Separate from Task, so that these names are not
/// visible in authors' classes.
class TaskLifecycle {
 public:
  /// Obeys the orders given to the task and to the tasks that run after it.
  static void ExecuteOrders(Task& task);
  /// Ends a task whose leader has ended.
  static void EndWithLeader(Task& task);
  /// Unbinds the task, and the tasks that run after it, from their thread until the next cycle.
  static void Unbind(Task& task);

  template <typename Action>
  static void ForEachFollower(Task& task, Action action) {
    const GuardedPointer<TaskFollowers>::Call call(task.followers_);
    if (call.get() == nullptr) return;
    for (Task* follower : *call.get()) action(*follower);
  }

  /// The time at which the next effect of a command expires, of the task or of one that runs after
  /// it.
  [[nodiscard]] static SteadyTime NextExpiry(Task& task);

  /// Wakes the thread that makes the task's cycles, so that it obeys orders. Any thread.
  static void WakeThread(Task& task);

  // For managers.

  /// Adds `task`, which is at rest. The leader sees it when it next reads its list of followers.
  static void AddFollower(Task& leader, Task& task);
  /// kTimeout if a cycle of `leader` that may use the task has not ended by `deadline`; then
  /// nothing has changed.
  static Result<void> RemoveFollower(Task& leader, Task& task, SteadyTime deadline);
  static void SetLeader(Task& task, Task* leader);
  /// The first leader in the chain, whose thread makes the task's cycles.
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
