#include <tendon/task/task_lifecycle.h>

#include <tendon/interface/execution/block_when_full.h>
#include <tendon/task/cycle_log.h>

#include <algorithm>
#include <mutex>
#include <utility>

namespace tendon {
namespace {

/// Protects the leaders of all tasks. There is only one mutex, because one mutex per task could be
/// locked in opposite orders.
std::mutex& LeadersMutex() {
  // Never freed, because a task may exist until the program ends.
  static std::mutex& mutex = *new std::mutex;
  return mutex;
}

}  // namespace

void TaskLifecycle::ExecuteOrders(Task& task) {
  if (task.has_failed_outside_.Get()) EnterFaultFromOutside(task);
  const TaskOrder order = task.order_.Get();
  if (order.number != std::exchange(task.obeyed_, order.number)) {
    const ComponentState now = task.state();
    switch (order.request) {
      case LifecycleRequest::kStart:
        if (now == ComponentState::kSuspended) {
          Continue(task);
        } else if (task.is_starting()) {  // false if the task has become faulted
          Begin(task);
        }
        break;
      case LifecycleRequest::kSuspend:
        if (now == ComponentState::kActive) Suspend(task);
        break;
      case LifecycleRequest::kStop:
        if (IsRunning(now)) {
          Finish(task);
        } else if (order.ends_start && task.is_starting()) {  // the task never ran
          task.SetState(ComponentState::kFinished);
        }
        break;
    }
  }
  if (task.state() == ComponentState::kActive) (void)Report(task, &Task::ReportConnections);
  ForEachFollower(task, [](Task& follower) { ExecuteOrders(follower); });
}

/// Returns false if one of the author's functions has thrown.
bool TaskLifecycle::Report(Task& task, bool (Task::*report)()) {
  const LogDeferralScope deferral_scope(*task.log_);
  task.inbox()->BindToThisThread();
  if ((task.*report)()) return true;
  task.EndFollowers();
  task.inbox()->Unbind();
  return false;
}

void TaskLifecycle::Unbind(Task& task) {
  task.inbox()->Unbind();
  ForEachFollower(task, [](Task& follower) { Unbind(follower); });
}

void TaskLifecycle::EnterFaultFromOutside(Task& task) {
  task.has_failed_outside_.Set(false);
  std::string reason;
  {
    const std::scoped_lock lock(task.outside_mutex_);
    reason = task.outside_reason_;
  }
  task.Component::FaultFromOutside(reason);  // the task may have just ended
  task.EndFollowers();
}

void TaskLifecycle::Begin(Task& task) {
  task.inbox()->BindToThisThread();
  task.started_period_.Set(std::chrono::duration<double>(task.period()));
  task.meter_.Start(task.started_period_.Get());
  if (!Report(task, &Task::ReportBeforeStartup)) return;
  if (!task.RunGuarded("Startup", [&task] { task.Startup(); })) {
    task.EndFollowers();
    task.inbox()->Unbind();
    return;
  }
  BecomeActive(task);
  if (task.leader() != nullptr && task.leader()->state() == ComponentState::kSuspended) {
    task.rests_with_leader_ = true;
    Suspend(task);
  }
}

void TaskLifecycle::BecomeActive(Task& task) {
  task.rests_with_leader_ = false;
  task.meter_.Interrupt();
  task.last_begin_.Set(SteadyClock().Now());
  task.OnActive();
  task.SetState(ComponentState::kActive);
}

void TaskLifecycle::Suspend(Task& task) {
  ForEachFollower(task, [](Task& follower) {
    if (follower.state() != ComponentState::kActive) return;
    follower.rests_with_leader_ = true;
    Suspend(follower);
  });
  task.SetState(ComponentState::kSuspended);
}

void TaskLifecycle::Continue(Task& task) {
  if (task.leader() != nullptr && task.leader()->state() != ComponentState::kActive) {
    task.rests_with_leader_ = true;
    return;
  }
  if (!Report(task, &Task::ReportResume)) return;
  BecomeActive(task);
  ForEachFollower(task, [](Task& follower) {
    if (follower.rests_with_leader_ && follower.state() == ComponentState::kSuspended) {
      Continue(follower);
    }
  });
}

void TaskLifecycle::Finish(Task& task) {
  task.inbox()->BindToThisThread();
  task.EndFollowers();
  const auto clean_up = [&task] {
    const BlockWhenFull get_through;
    task.Cleanup();
  };
  if (task.RunGuarded("Cleanup", clean_up)) {
    task.SetState(ComponentState::kFinished);
  }
  task.EndFollowers();  // again, because a follower may have just been started
  task.inbox()->Unbind();
}

void TaskLifecycle::EndWithLeader(Task& task) {
  task.obeyed_ = task.order_.Get().number;
  if (IsRunning(task.state())) {
    Finish(task);
  } else if (task.is_starting()) {
    task.EnterFault("Startup",
                    "'" + task.leader()->name() + "' has ended, and this task runs after it");
  }
}

SteadyTime TaskLifecycle::NextExpiry(Task& task) {
  SteadyTime next = task.next_expiry();
  ForEachFollower(task, [&next](Task& follower) {
    if (follower.state() == ComponentState::kActive) next = std::min(next, NextExpiry(follower));
  });
  return next;
}

void TaskLifecycle::WakeThread(Task& task) {
  const std::scoped_lock lock(LeadersMutex());  // so that the leaders do not change
  Task& root = RootOf(task);
  root.orders_.Set(root.orders_.Get() + 1);
  root.wakeup_.Notify();
}

void TaskLifecycle::AddFollower(Task& leader, Task& task) {
  auto next = leader.follower_list_ ? std::make_unique<TaskFollowers>(*leader.follower_list_)
                                    : std::make_unique<TaskFollowers>();
  next->push_back(&task);
  SetLeader(task, &leader);
  leader.follower_list_.swap(next);
  if (leader.followers_.TryExchange(leader.follower_list_.get(), SteadyTime::min())) {
    leader.retired_lists_.clear();
  } else {
    leader.retired_lists_.push_back(std::move(next));
  }
}

Result<void> TaskLifecycle::RemoveFollower(Task& leader, Task& task, SteadyTime deadline) {
  auto next = std::make_unique<TaskFollowers>(*leader.follower_list_);
  std::erase(*next, &task);
  leader.follower_list_.swap(next);
  if (leader.followers_.TryExchange(leader.follower_list_.get(), deadline)) {
    leader.retired_lists_.clear();
    SetLeader(task, nullptr);
    return {};
  }
  // Restores the old list. The new list is not freed, because a cycle may already use it.
  leader.follower_list_.swap(next);
  leader.followers_.TryExchange(leader.follower_list_.get(), SteadyTime::min());
  leader.retired_lists_.push_back(std::move(next));
  return Error{ErrorCode::kTimeout,
               "the cycle of '" + leader.name() +
                   "' does not end; this task, or a task that runs after it, is busy in Run()"};
}

void TaskLifecycle::SetLeader(Task& task, Task* leader) {
  const std::scoped_lock lock(LeadersMutex());
  task.leader_.Set(leader);
}

}  // namespace tendon
