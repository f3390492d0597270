#pragma once

#include <tendon/lockfree/guarded_pointer.h>
#include <tendon/lockfree/wakeup.h>
#include <tendon/state/state_table.h>
#include <tendon/task/component.h>
#include <tendon/task/cycle_meter.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace tendon {

class CycleLog;
class Task;
class TaskLifecycle;

/// The effect of posting a call to the inbox of a task.
enum class PostWakeup {
  kWait,  ///< the call is queued until a cycle executes it
  kWake,  ///< also wakes the thread that sleeps on Task::wakeup()
};

using TaskFollowers = std::vector<Task*>;

/// A manager's order to a task.
struct alignas(8) TaskOrder {  // one word, so threads can publish it without a lock
  std::uint32_t number = 0;
  LifecycleRequest request = LifecycleRequest::kStop;
  bool ends_start = false;  ///< for kStop: also ends a start in progress
};

/// A component with cycles, a state table and mailboxes. Commands and events from other components
/// stay in the mailboxes until Run() calls ProcessQueuedCommands().
///
/// The derived classes, such as PeriodicTask, decide when a cycle is due. A task that has its own
/// thread can instead run after another task, its leader: in the leader's thread, after each of the
/// leader's cycles.
///
/// Managers give orders to the task. The thread that makes the cycles executes the orders between
/// two cycles.
class Task : public Component {
 public:
  [[nodiscard]] std::vector<const StateTable*> tables() const override;
  void Seal() override;

  /// The task after which this one runs, or null. For managers.
  [[nodiscard]] const Task* leader() const { return leader_.Get(); }
  /// For managers: from now on, the task does not run after another task. Fails with kTimeout if
  /// the present cycle of the leader has not ended by `deadline`; then nothing is changed. The task
  /// must be at rest.
  Result<void> LeaveLeader(SteadyTime deadline);
  /// The time since the last cycle began; 0 while the task is not active. Any thread.
  [[nodiscard]] std::chrono::nanoseconds SinceLastCycle(SteadyTime now) const noexcept;
  /// The period() at the time of the last start. Any thread.
  [[nodiscard]] std::chrono::duration<double> started_period() const noexcept {
    return started_period_.Get();
  }

 protected:
  explicit Task(std::string name, PostWakeup post_wakeup = PostWakeup::kWait);
  ~Task() override;

  /// Returns the table `state`. Each cycle records the variables of this table after Run().
  StateTable& state_table() { return *tables_.front(); }
  /// Adds a table. It can be read through the provided interface `state-NAME`. Each cycle records
  /// one row of the table.
  StateTable& AddStateTable(const std::string& name);

  /// Sets the shortest time between two rows of the task's tables. Must be called in the
  /// constructor, before tables are added.
  void SetShortestInterval(std::chrono::nanoseconds interval);

  /// Does the author's work of one cycle, in the task's thread. If it throws, the task becomes
  /// faulted. Log() only queues records here (CycleLog).
  virtual void Run() = 0;

  /// Executes the queued commands and events, and returns their number. Must be called in the
  /// task's thread. The author calls it in Run(), at a suitable point of the control cycle.
  std::size_t ProcessQueuedCommands();

  // For derived kinds of tasks. These functions must be called in the thread that makes the cycles.

  /// Executes the orders for this task and for the tasks that run after it.
  void ObeyOrders();
  /// Returns true if there are orders to execute.
  [[nodiscard]] bool has_orders() const noexcept { return orders_.Get() != orders_seen_; }
  /// Makes a cycle: calls Run(), adds a row to every table, and makes the cycles of the tasks that
  /// run after this one. Returns false if this task is now faulted.
  bool DoCycle(SteadyTime begin, SteadyTime due);
  bool DoCycle(SteadyTime now) { return DoCycle(now, now); }
  /// The time when the last cycle of this task and of all tasks that run after it ended.
  [[nodiscard]] SteadyTime cycle_end() const { return cycle_end_; }
  /// Adds skipped cycles to the statistics of this task and of the tasks that run after it.
  void AddOverruns(std::uint64_t cycles);
  /// Ends the tasks that run after this one. Called when the thread makes no more cycles.
  void EndFollowers();
  /// Called when the task has become active, after a start or a resumption.
  virtual void OnActive() {}

  /// Wakes the thread that makes the cycles. It is notified of orders, and of posts if the task
  /// uses PostWakeup::kWake.
  Wakeup<>& wakeup() { return wakeup_; }
  /// The expected time between two rows. By default, the tables are long enough for about one
  /// second of rows.
  [[nodiscard]] virtual std::chrono::nanoseconds row_period() const;

  // For managers.

  /// Prepares a start: drops the calls that were still queued when the task ended. Called before
  /// the order to start is given.
  void PrepareStart();
  /// Gives an order to the thread that makes the cycles. If there is no such thread, the calling
  /// thread executes the order.
  void GiveOrder(LifecycleRequest request, bool ends_start = false);
  void Pause() override { GiveOrder(LifecycleRequest::kSuspend); }
  Result<void> Resume() override;
  void Halt() override { GiveOrder(LifecycleRequest::kStop, is_starting()); }
  /// Makes the task run after `leader` instead of its former leader. The task must be at rest.
  /// Fails like LeaveLeader().
  Result<void> JoinLeader(Task& leader, SteadyTime deadline);

  void FaultFromOutside(const std::string& reason) override;
  void DeliverPeerChange(RequiredInterface& interface) override;
  void DeliverDisconnectedClient(DisconnectedClient client) override;

 private:
  friend TaskLifecycle;  // does the work between two cycles

  void EndExpiredNow();

  std::shared_ptr<CycleLog> log_;
  std::vector<std::unique_ptr<StateTable>> tables_;
  std::chrono::nanoseconds shortest_interval_{0};
  CycleMeter meter_;
  Wakeup<> wakeup_;
  const char* running_function_ = "Run";  // the author's function that is running
  bool rests_with_leader_ = false;
  SteadyTime cycle_end_{};
  Published<SteadyTime> last_begin_;
  Published<std::chrono::duration<double>> started_period_;

  Published<TaskOrder> order_;
  std::uint32_t obeyed_ = 0;
  // Counts the orders for all tasks in this thread, and the faults that other threads report. Only
  // the first task in the chain of leaders uses it.
  Published<std::uint64_t> orders_;
  std::uint64_t orders_seen_ = 0;

  Flag has_failed_outside_;
  std::mutex outside_mutex_;  // guards outside_reason_
  std::string outside_reason_;

  Published<Task*> leader_;
  std::unique_ptr<TaskFollowers> follower_list_;
  // Old lists are kept, because a cycle may still use them.
  std::vector<std::unique_ptr<TaskFollowers>> retired_lists_;
  GuardedPointer<TaskFollowers> followers_;
};

/// Returns true if `component` runs after `leader`, directly or through other tasks.
[[nodiscard]] bool RunsAfter(const Component& component, const Component& leader);

}  // namespace tendon
