#pragma once

#include <tendon/lockfree/guarded_pointer.h>
#include <tendon/lockfree/wakeup.h>
#include <tendon/state/state_table.h>
#include <tendon/task/component.h>
#include <tendon/task/cycle_meter.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace tendon {

class CycleLog;
class Task;
class TaskLifecycle;

/// The effect of a posted call on the thread that makes the cycles.
enum class PostWakeup {
  kWait,  ///< the post waits until a cycle executes it
  kWake,  ///< the post wakes a thread that sleeps on Task::wakeup()
};

using TaskFollowers = std::vector<Task*>;

/// A manager's order to a task.
struct alignas(8) TaskOrder {  // one word, so that it is published without a lock
  std::uint32_t number = 0;
  LifecycleRequest request = LifecycleRequest::kStop;
  bool ends_start = false;  ///< for a stop: also ends a start in progress
};

/// A component with cycles, a state table and mailboxes. Commands and events that others send wait
/// until its Run() calls ProcessQueuedCommands().
///
/// The derived kinds of tasks decide when a cycle is due. A task with a thread of its own may run
/// after another task instead, in the thread and the cycles of that task.
///
/// Managers give orders. The thread that makes the cycles obeys them between two cycles.
class Task : public Component {
 public:
  [[nodiscard]] std::vector<const StateTable*> tables() const override;
  void Seal() override;

  /// The task after which this one runs, or null. For managers.
  [[nodiscard]] const Task* leader() const { return leader_.Get(); }
  /// For managers: from now on, the task does not run after another one. kTimeout if the leader's
  /// cycle has not ended by `deadline`; then nothing has changed. The task must be at rest.
  Result<void> LeaveLeader(SteadyTime deadline);
  /// Time since the last cycle began; 0 while the task is not active. Any thread.
  [[nodiscard]] std::chrono::nanoseconds SinceLastCycle(SteadyTime now) const noexcept;
  /// The period() at the last start. Any thread.
  [[nodiscard]] std::chrono::duration<double> started_period() const noexcept {
    return started_period_.Get();
  }

 protected:
  explicit Task(std::string name, PostWakeup post_wakeup = PostWakeup::kWait);
  ~Task() override;

  /// The table `state`: variables added to it are recorded once a cycle, after Run().
  StateTable& state_table() { return *tables_.front(); }
  /// Adds a table, which is the provided interface `state-NAME`; also recorded once a cycle.
  StateTable& AddStateTable(const std::string& name);

  /// Sets the shortest time between two rows of its tables. For constructors, before tables are
  /// added.
  void SetShortestInterval(std::chrono::nanoseconds interval);

  /// One cycle of the author's work, in the task's thread. An exception faults the task. Log()
  /// queues its records (CycleLog).
  virtual void Run() = 0;

  /// Executes the queued commands and events in the calling thread, which must be the task's, and
  /// returns their number. The author calls it in Run(), at the point of the control cycle that
  /// suits.
  std::size_t ProcessQueuedCommands();

  // For derived kinds of tasks, in the thread that makes the cycles.

  /// Obeys the orders given to this task and to the tasks that run after it.
  void ObeyOrders();
  /// True if there are orders to obey.
  [[nodiscard]] bool has_orders() const noexcept { return orders_.Get() != orders_seen_; }
  /// Runs Run(), adds a row to every table, and makes the cycles of the tasks that run after this
  /// one. False if this task is now faulted.
  bool DoCycle(SteadyTime begin, SteadyTime due);
  bool DoCycle(SteadyTime now) { return DoCycle(now, now); }
  /// End of the last cycle, including the cycles of the tasks that run after this one.
  [[nodiscard]] SteadyTime cycle_end() const { return cycle_end_; }
  /// Adds skipped cycles to the statistics of this task and of the tasks that run after it.
  void AddOverruns(std::uint64_t cycles);
  /// Ends the tasks that run after this one. Called by a thread that makes no more cycles.
  void EndFollowers();
  /// Called when the task has become active, after a start or a resumption.
  virtual void OnActive() {}

  /// Notified of orders, and of posts with PostWakeup::kWake.
  Wakeup<>& wakeup() { return wakeup_; }
  /// Time between two rows, from which the default length of tables follows: about one second.
  [[nodiscard]] virtual std::chrono::nanoseconds row_period() const;

  // For managers.

  /// Prepares a start. Called before the start is ordered. Drops the calls that were still queued
  /// when the task ended.
  void PrepareStart();
  /// Gives an order to the thread that runs the cycles, which executes it. If there is no such
  /// thread, the calling thread executes the order.
  void GiveOrder(LifecycleRequest request, bool ends_start = false);
  void Pause() override { GiveOrder(LifecycleRequest::kSuspend); }
  Result<void> Resume() override;
  void Halt() override { GiveOrder(LifecycleRequest::kStop, is_starting()); }
  /// Makes the task run after `leader` instead of its former leader. Both tasks must exist, and
  /// this one must be at rest. Errors are those of LeaveLeader().
  Result<void> JoinLeader(Task& leader, SteadyTime deadline);

  void FaultFromOutside(const std::string& reason) override;
  void DeliverPeerChange(RequiredInterface& interface) override;
  void DeliverDisconnectedClient(DisconnectedClient client) override;

 private:
  friend TaskLifecycle;  // the rest of a task's work; see there

  void EndExpiredNow();

  std::shared_ptr<CycleLog> log_;
  std::vector<std::unique_ptr<StateTable>> tables_;
  std::chrono::nanoseconds shortest_interval_{0};
  CycleMeter meter_;
  Wakeup<> wakeup_;
  const char* doing_ = "Run";  // the author's function that runs now
  bool rests_with_leader_ = false;
  SteadyTime cycle_end_{};
  Published<SteadyTime> last_begin_;
  Published<std::chrono::duration<double>> started_period_;

  Published<TaskOrder> order_;
  std::uint32_t obeyed_ = 0;
  Published<std::uint64_t> orders_;  // number of orders and outside faults of all tasks in this
                                     // thread; used in the first task
  std::uint64_t orders_seen_ = 0;

  Flag has_failed_outside_;
  std::mutex outside_mutex_;  // guards outside_reason_
  std::string outside_reason_;

  Published<Task*> leader_;
  std::unique_ptr<TaskFollowers> follower_list_;
  std::vector<std::unique_ptr<TaskFollowers>> retired_lists_;  // a cycle may still use them
  GuardedPointer<TaskFollowers> followers_;
};

}  // namespace tendon
