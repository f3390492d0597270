#pragma once

#include <tendon/state/state_table.h>
#include <tendon/task/component.h>
#include <tendon/task/cycle_statistics.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace tendon {

/// A component with a thread, a state table and mailboxes: commands and events that others send
/// wait until its Run() calls ProcessQueuedCommands().
///
/// Kinds of tasks differ in what makes a cycle due; they derive from this class and implement
/// Loop().
class Task : public Component {
 public:
  [[nodiscard]] std::vector<const StateTable*> tables() const override;
  void Seal() override;

 protected:
  explicit Task(std::string name);
  ~Task() override;

  /// The table `state`: variables added to it are recorded once a cycle, after Run().
  StateTable& state_table() { return *tables_.front(); }
  /// A further table, seen by others as the interface `state-NAME`, also recorded once a cycle.
  StateTable& AddStateTable(const std::string& name);

  /// One cycle of the author's work, in the task's thread. An exception faults the task.
  virtual void Run() = 0;

  /// Executes the commands and events that have arrived, in the calling thread, which is the
  /// task's; how many they were. Called by the author in Run(): when is a control decision.
  std::size_t ProcessQueuedCommands() { return inbox()->ExecuteQueued(); }

  /// Calls DoCycle() whenever one is due, until stop_requested().
  virtual void Loop() = 0;
  /// Run() and a row of every table. False once the task is faulted.
  bool DoCycle(SteadyTime now);
  [[nodiscard]] bool stop_requested() const noexcept { return stop_.Get(); }
  /// Written by Loop() before each cycle.
  CycleStatistics& cycle() { return cycle_; }
  /// The time between two rows, by which tables get their length: about a second of rows.
  [[nodiscard]] virtual std::chrono::nanoseconds row_period() const;

  Result<void> Launch() override;
  void Halt() override;

  /// Ends the thread; to be called by the destructor of every class that implements Loop(), for a
  /// thread must not outlive what it runs.
  void Join();

 private:
  void ThreadMain();

  std::vector<std::unique_ptr<StateTable>> tables_;
  CycleStatistics cycle_;
  Flag stop_;
  std::thread thread_;
};

}  // namespace tendon
