#include <tendon/task/task.h>

#include <tendon/base/log.h>
#include <tendon/base/name.h>
#include <tendon/base/text.h>
#include <tendon/interface/column_offer.h>
#include <tendon/task/cycle_log.h>
#include <tendon/task/task_lifecycle.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace tendon {

Task::Task(std::string name, PostWakeup post_wakeup)
    : Component(std::move(name),
                std::make_unique<Inbox>(post_wakeup == PostWakeup::kWake ? &wakeup_ : nullptr)),
      log_(CycleLog::OfThisProcess()) {
  tables_.push_back(std::make_unique<StateTable>("state"));
  state_table().Add(meter_.cycle(), "Cycle");
  state_table().Add(meter_.summary(), "CycleSummary");
}

Task::~Task() {
  (void)LeaveLeader(SteadyTime::max());
  TaskLifecycle::ForEachFollower(
      *this, [](Task& follower) { TaskLifecycle::SetLeader(follower, nullptr); });
}

std::vector<const StateTable*> Task::tables() const {
  std::vector<const StateTable*> all;
  for (const auto& table : tables_) all.push_back(table.get());
  return all;
}

StateTable& Task::AddStateTable(const std::string& name) {
  RequireName("state table", name);
  for (const auto& table : tables_) {
    if (table->name() == "state-" + name) {
      throw ConfigurationError("state table '" + name + "' already exists in '" + this->name() +
                               "'; choose another name");
    }
  }
  if (FindProvided(state_table().name()) != nullptr) {  // the task is already sealed
    throw AddedTooLate("state table '" + name + "'", "component '" + this->name() + "'",
                       "state " + std::string(ToString(state())));
  }
  tables_.push_back(std::make_unique<StateTable>("state-" + name));
  tables_.back()->SetShortestInterval(shortest_interval_);
  return *tables_.back();
}

void Task::SetShortestInterval(std::chrono::nanoseconds interval) {
  shortest_interval_ = interval;
  for (const auto& table : tables_) table->SetShortestInterval(interval);
}

void Task::Seal() {
  for (const auto& table : tables_) {
    if (table->length() == 0) table->SetLength(table->LengthFor(row_period()));
    table->Prepare();
    AddColumnReads(*table, AddReservedInterface(table->name()));
  }
  Component::Seal();
}

std::chrono::nanoseconds Task::row_period() const { return std::chrono::milliseconds(1); }

std::chrono::nanoseconds Task::SinceLastCycle(SteadyTime now) const noexcept {
  if (state() != ComponentState::kActive) return {};
  return std::max(std::chrono::nanoseconds(0), now - last_begin_.Get());
}

std::size_t Task::ProcessQueuedCommands() {
  const char* const before = std::exchange(running_function_, kInHandler);
  const std::size_t executed = inbox()->ExecuteQueued();
  EndExpiredNow();
  running_function_ = before;
  return executed;
}

/// Ends the effects of commands that have expired. Called after the queued commands, because they
/// may renew an effect.
void Task::EndExpiredNow() {
  if (next_expiry() == SteadyTime::max()) return;
  EndExpired(SteadyClock().Now());
}

bool Task::DoCycle(SteadyTime begin, SteadyTime due) {
  cycle_end_ = begin;
  inbox()->BindToThisThread();
  last_begin_.Set(begin);
  meter_.Begin(begin, due);
  running_function_ = "Run";
  const bool is_good = RunGuarded(running_function_, [this] {
    const LogDeferralScope deferral_scope(*log_);
    Run();
    EndExpiredNow();
  });
  if (is_good) {
    for (const auto& table : tables_) table->AdvanceAfterCycle(begin);
  }
  cycle_end_ = SteadyClock().Now();
  meter_.End(cycle_end_);
  if (!is_good) {
    EndFollowers();
    inbox()->Unbind();
    return false;
  }
  TaskLifecycle::ForEachFollower(*this, [this, due](Task& follower) {
    if (follower.state() != ComponentState::kActive) return;
    follower.DoCycle(cycle_end_, due);
    cycle_end_ = follower.cycle_end_;
  });
  return true;
}

void Task::AddOverruns(std::uint64_t cycles) {
  if (cycles == 0) return;
  meter_.AddOverruns(cycles);
  TaskLifecycle::ForEachFollower(*this, [cycles](Task& follower) {
    if (follower.state() == ComponentState::kActive) follower.AddOverruns(cycles);
  });
}

void Task::ObeyOrders() {
  orders_seen_ = orders_.Get();
  TaskLifecycle::ExecuteOrders(*this);
}

void Task::EndFollowers() {
  TaskLifecycle::ForEachFollower(*this,
                                 [](Task& follower) { TaskLifecycle::EndWithLeader(follower); });
}

void Task::PrepareStart() {
  has_failed_outside_.Set(false);
  // The calls that were still queued when the task ended are outdated now.
  if (const std::size_t stale = inbox()->DiscardQueued(); stale > 0) {
    Log(LogLevel::kWarning, name(),
        Counted(stale, "call", "calls") + " that waited when the task ended " +
            (stale == 1 ? "was" : "were") + " dropped");
  }
}

void Task::GiveOrder(LifecycleRequest request, bool ends_start) {
  order_.Set({.number = order_.Get().number + 1, .request = request, .ends_start = ends_start});
  TaskLifecycle::WakeThread(*this);
  TaskLifecycle::RootOf(*this).ServeWaiting();
}

Result<void> Task::Resume() {
  if (leader() != nullptr && leader()->state() == ComponentState::kSuspended) {
    return Error{ErrorCode::kFailed, "component '" + name() + "' runs after '" + leader()->name() +
                                         "', which is suspended; start '" + leader()->name() +
                                         "' first"};
  }
  GiveOrder(LifecycleRequest::kStart);
  return {};
}

Result<void> Task::JoinLeader(Task& leader, SteadyTime deadline) {
  if (const auto left = LeaveLeader(deadline); !left) return left;
  TaskLifecycle::AddFollower(leader, *this);
  return {};
}

Result<void> Task::LeaveLeader(SteadyTime deadline) {
  Task* const leader = leader_.Get();
  return leader == nullptr ? Result<void>()
                           : TaskLifecycle::RemoveFollower(*leader, *this, deadline);
}

void Task::DeliverPeerChange(RequiredInterface& interface) {
  TaskLifecycle::WakeThread(*this);
  // This order is important. A task that was started before WakeThread() is not at rest here. A
  // task that is started later calls OnConnected() itself.
  if (is_at_rest()) interface.AdmitPeerAtRest();
}

void Task::DeliverDisconnectedClient(DisconnectedClient client) {
  QueueGoneClient(std::move(client));
  TaskLifecycle::WakeThread(*this);
}

void Task::FaultFromOutside(const std::string& reason) {
  if (!IsRunning(state())) return Component::FaultFromOutside(reason);
  {
    const std::scoped_lock lock(outside_mutex_);
    outside_reason_ = reason;
  }
  has_failed_outside_.Set(true);
  TaskLifecycle::WakeThread(*this);
}

bool RunsAfter(const Component& component, const Component& leader) {
  const auto* task = dynamic_cast<const Task*>(&component);
  while (task != nullptr && (task = task->leader()) != nullptr) {
    if (task == &leader) return true;
  }
  return false;
}

}  // namespace tendon
