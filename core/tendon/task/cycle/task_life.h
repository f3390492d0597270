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
  /// Faults the task because of what a handler has thrown in another thread; false where it has
  /// ended meanwhile.
  static bool EnterFaultFromOutside(Task& task);

  template <typename Action>
  static void ForEachFollower(Task& task, Action action) {
    const GuardedPointer<TaskFollowers>::Call call(task.followers_);
    if (call.get() == nullptr) return;
    for (Task* follower : *call.get()) action(*follower);
  }

  // For managers.

  /// kTimeout where a cycle of `leader` that uses the old list has not ended by `deadline`: it is
  /// kept.
  static Result<void> ReplaceFollowers(Task& leader, std::unique_ptr<TaskFollowers> next,
                                       SteadyTime deadline);
  /// The first of those in its thread.
  static Task& RootOf(Task& task) { return task.leader_ == nullptr ? task : RootOf(*task.leader_); }

 private:
  static void Begin(Task& task);
  static void BecomeActive(Task& task);
  static void Rest(Task& task);
  static void GoOn(Task& task);
  static void Finish(Task& task);
};

}  // namespace tendon
