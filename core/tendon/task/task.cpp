#include <tendon/base/log.h>
#include <tendon/base/name.h>
#include <tendon/base/os/thread.h>
#include <tendon/task/state_interface.h>
#include <tendon/task/task.h>

#include <cassert>
#include <utility>

namespace tendon {

Task::Task(std::string name) : Component(std::move(name), std::make_unique<Inbox>()) {
  tables_.push_back(std::make_unique<StateTable>("state"));
  state_table().Add(cycle_, "Cycle");
}

Task::~Task() { assert(!thread_.joinable()); }

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
  return *tables_.back();
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

bool Task::DoCycle(SteadyTime now) {
  if (!RunGuarded("Run", [this] { Run(); })) return false;
  for (const auto& table : tables_) table->Advance(now);
  return true;
}

Result<void> Task::Launch() {
  Join();
  stop_.Set(false);
  cycle_ = {};
  // What waited when the task ended was meant for the world as it was then.
  if (const std::size_t stale = inbox()->DiscardQueued(); stale > 0) {
    Log(LogLevel::kWarning, name(),
        std::to_string(stale) + " calls that waited when it ended were dropped");
  }
  // The component is active before its thread runs, so that Startup() may already be called upon.
  SetState(ComponentState::kActive);
  thread_ = std::thread([this] { ThreadMain(); });
  return {};
}

void Task::Halt() { Join(); }

void Task::Join() {
  stop_.Set(true);
  if (thread_.joinable()) thread_.join();
}

void Task::ThreadMain() {
  os::NameThisThread(name());
  if (!RunGuarded("Startup", [this] { Startup(); })) return;
  Loop();
  if (state() == ComponentState::kFaulted) return;
  if (RunGuarded("Cleanup", [this] { Cleanup(); })) SetState(ComponentState::kFinished);
}

}  // namespace tendon
