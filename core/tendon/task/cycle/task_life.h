#pragma once

#include <tendon/task/task.h>

#include <memory>

namespace tendon {

/// The work of the thread that makes a task's cycles between two of them: it obeys orders, for the
/// task and for those that run after it. Not in Task, whose authors would see all these names.
class TaskLife {
 public:
  /// Obeys the orders given to the task and to those that run after it.
  static void Obey(Task& task);
  /// Ends a task whose leader has ended.
  static void EndWithLeader(Task& task);
  /// Until the next cycle, the task and those that run after it belong to no thread.
  static void Unbind(Task& task);

  template <typename Action>
  static void ForEachFollower(Task& task, Action action) {
    const GuardedPointer<TaskFollowers>::Call call(task.followers_);
    if (call.get() == nullptr) return;
    for (Task* follower : *call.get()) action(*follower);
  }

  /// When the next command of the task, or of one that runs after it, must be renewed.
  [[nodiscard]] static SteadyTime NextExpiry(Task& task);

  /// Makes the thread that runs the task's cycles obey, whichever thread that is. Any thread.
  static void CallThread(Task& task);

  // For managers.

  /// Adds `task`, which is at rest. The leader sees it at the next look at its followers.
  static void AddFollower(Task& leader, Task& task);
  /// kTimeout if a cycle of `leader` that may use the task has not ended by `deadline`; then
  /// nothing has changed.
  static Result<void> RemoveFollower(Task& leader, Task& task, SteadyTime deadline);
  static void SetLeader(Task& task, Task* leader);
  /// The first task in its thread.
  static Task& RootOf(Task& task) {
    Task* const leader = task.leader_.Get();
    return leader == nullptr ? task : RootOf(*leader);
  }

 private:
  static bool Tell(Task& task, bool (Task::*tell)());
  static void EnterFaultFromOutside(Task& task);
  static void Begin(Task& task);
  static void BecomeActive(Task& task);
  static void Rest(Task& task);
  static void GoOn(Task& task);
  static void Finish(Task& task);
};

}  // namespace tendon
