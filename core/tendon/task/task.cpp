#include <tendon/base/log.h>
#include <tendon/base/name.h>
#include <tendon/task/state_interface.h>
#include <tendon/task/task.h>

#include <algorithm>
#include <utility>

namespace tendon {
namespace {

bool IsRunning(ComponentState state) {
  return state == ComponentState::kActive || state == ComponentState::kSuspended;
}

}  // namespace

Task::Task(std::string name, Posts posts)
    : Component(std::move(name),
                std::make_unique<Inbox>(posts == Posts::kWake ? &wakeup_ : nullptr)) {
  tables_.push_back(std::make_unique<StateTable>("state"));
  state_table().Add(meter_.cycle(), "Cycle");
  state_table().Add(meter_.summary(), "CycleSummary");
}

Task::~Task() {
  Unfollow();
  ForEachFollower([](Task& follower) { follower.leader_ = nullptr; });
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
                               "'");
    }
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
  const char* const before = std::exchange(doing_, "a command or event handler");
  const std::size_t executed = inbox()->ExecuteQueued();
  doing_ = before;
  return executed;
}

bool Task::DoCycle(SteadyTime begin, SteadyTime due) {
  inbox()->BindToThisThread();
  last_begin_.Set(begin);
  meter_.Begin(begin, due);
  doing_ = "Run";
  const bool is_good = RunGuarded(doing_, [this] { Run(); });
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
  ForEachFollower([this, due](Task& follower) {
    if (follower.state() != ComponentState::kActive) return;
    follower.DoCycle(cycle_end_, due);
    cycle_end_ = follower.cycle_end_;
  });
  return true;
}

void Task::AddOverruns(std::uint64_t cycles) {
  if (cycles == 0) return;
  meter_.AddOverruns(cycles);
  ForEachFollower([cycles](Task& follower) {
    if (follower.state() == ComponentState::kActive) follower.AddOverruns(cycles);
  });
}

void Task::ObeyOrders() {
  orders_seen_ = orders_.Get();
  Obey();
}

void Task::Obey() {
  const NumberedOrder order = order_.Get();
  if (order.number != std::exchange(obeyed_, order.number)) {
    const ComponentState now = state();
    switch (order.request) {
      case LifeRequest::kStart:
        if (now == ComponentState::kSuspended) {
          GoOn();
        } else if (now != ComponentState::kActive) {
          Begin();
        }
        break;
      case LifeRequest::kSuspend:
        if (now == ComponentState::kActive) Rest();
        break;
      case LifeRequest::kStop:
        if (IsRunning(now)) Finish();
        break;
    }
  }
  ForEachFollower([](Task& follower) { follower.Obey(); });
}

void Task::Begin() {
  inbox()->BindToThisThread();
  started_period_.Set(std::chrono::duration<double>(period()));
  meter_.Start(started_period_.Get());
  if (!RunGuarded("Startup", [this] { Startup(); })) {
    EndFollowers();
    inbox()->Unbind();
    return;
  }
  BecomeActive();
  if (leader_ != nullptr && leader_->state() == ComponentState::kSuspended) {
    rests_with_leader_ = true;
    Rest();
  }
}

void Task::BecomeActive() {
  rests_with_leader_ = false;
  meter_.Interrupt();
  last_begin_.Set(SteadyClock().Now());
  OnActive();
  SetState(ComponentState::kActive);
}

void Task::Rest() {
  ForEachFollower([](Task& follower) {
    if (follower.state() != ComponentState::kActive) return;
    follower.rests_with_leader_ = true;
    follower.Rest();
  });
  SetState(ComponentState::kSuspended);
}

void Task::GoOn() {
  if (leader_ != nullptr && leader_->state() != ComponentState::kActive) {
    rests_with_leader_ = true;
    return;
  }
  BecomeActive();
  ForEachFollower([](Task& follower) {
    if (follower.rests_with_leader_ && follower.state() == ComponentState::kSuspended) {
      follower.GoOn();
    }
  });
}

void Task::Finish() {
  inbox()->BindToThisThread();
  EndFollowers();
  if (RunGuarded("Cleanup", [this] { Cleanup(); })) SetState(ComponentState::kFinished);
  EndFollowers();  // one may have been asked to start meanwhile
  inbox()->Unbind();
}

void Task::EndFollowers() {
  ForEachFollower([](Task& follower) { follower.EndWithLeader(); });
}

void Task::EndWithLeader() {
  obeyed_ = order_.Get().number;
  if (IsRunning(state())) {
    Finish();
  } else if (is_starting()) {
    EnterFault("Startup", "'" + leader_->name() + "', after which it runs, has ended");
  }
}

void Task::PrepareStart() {
  // What waited when the task ended was meant for the world as it was then.
  if (const std::size_t stale = inbox()->DiscardQueued(); stale > 0) {
    Log(LogLevel::kWarning, name(),
        std::to_string(stale) + " calls that waited when it ended were dropped");
  }
}

void Task::Order(LifeRequest request) {
  order_.Set({.number = order_.Get().number + 1, .request = request});
  Task& first = root();
  first.orders_.Set(first.orders_.Get() + 1);
  first.wakeup_.Notify();
  first.ServeWaiting();
}

Result<void> Task::Resume() {
  if (leader_ != nullptr && leader_->state() == ComponentState::kSuspended) {
    return Error{ErrorCode::kFailed, "component '" + name() + "' runs after '" + leader_->name() +
                                         "', which is suspended; start '" + leader_->name() +
                                         "' first"};
  }
  Order(LifeRequest::kStart);
  return {};
}

void Task::Follow(Task& leader) {
  Unfollow();
  auto next = leader.follower_list_ ? std::make_unique<Followers>(*leader.follower_list_)
                                    : std::make_unique<Followers>();
  next->push_back(this);
  leader_ = &leader;
  leader.ReplaceFollowers(std::move(next));
}

void Task::Unfollow() {
  if (leader_ == nullptr) return;
  auto next = std::make_unique<Followers>(*leader_->follower_list_);
  std::erase(*next, this);
  std::exchange(leader_, nullptr)->ReplaceFollowers(std::move(next));
}

void Task::ReplaceFollowers(std::unique_ptr<Followers> next) {
  followers_.Exchange(next.get());  // waits until no cycle uses the old list
  follower_list_ = std::move(next);
}

}  // namespace tendon
