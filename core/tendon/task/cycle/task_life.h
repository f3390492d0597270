#pragma once

#include <tendon/task/task.h>

#include <memory>

namespace tendon {

/// What the thread that makes a task's cycles does between two of them: obeys, for the task and for
/// those that run after it. Apart from Task, whose authors would see all these names.
class TaskLife {
 public:
  /// Obeys what has been asked of the task and of those that run after it.
  static void Obey(Task& task);
  /// Ends a task whose leader has ended.
  static void EndWithLeader(Task& task);
  /// It and those that run after it belong to no thread until the next cycle.
  static void Unbind(Task& task);

  template <typename Action>
  static void ForEachFollower(Task& task, Action action) {
    const GuardedPointer<TaskFollowers>::Call call(task.followers_);
    if (call.get() == nullptr) return;
    for (Task* follower : *call.get()) action(*follower);
  }

  /// When the next command must be renewed, of the task or of one that runs after it.
  [[nodiscard]] static SteadyTime NextExpiry(Task& task);

  /// Has the thread that makes the task's cycles obey, whichever it is. Any thread.
  static void CallThread(Task& task);

  // For managers.

  /// From the leader's next look at its followers on the task, which is at rest, is one of them.
  static void AddFollower(Task& leader, Task& task);
  /// kTimeout where a cycle of `leader` that may use the task has not ended by `deadline`: nothing
  /// has changed then.
  static Result<void> RemoveFollower(Task& leader, Task& task, SteadyTime deadline);
  static void SetLeader(Task& task, Task* leader);
  /// The first of those in its thread.
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
