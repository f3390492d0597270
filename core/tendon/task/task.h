#pragma once

#include <tendon/lockfree/guarded_pointer.h>
#include <tendon/lockfree/wakeup.h>
#include <tendon/state/state_table.h>
#include <tendon/task/component.h>
#include <tendon/task/cycle/cycle_meter.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace tendon {

class CycleLog;
class Task;
class TaskLife;

/// What a post does to the thread that makes the cycles.
enum class Posts {
  kWait,  ///< the post waits until a cycle executes it
  kWake,  ///< it wakes a thread that sleeps on Task::wakeup()
};

using TaskFollowers = std::vector<Task*>;

/// What managers ask of a task.
struct alignas(8) TaskOrder {  // one word, so that it is published without a lock
  std::uint32_t number = 0;
  LifeRequest request = LifeRequest::kStop;
  bool ends_start = false;  ///< a stop that also ends a start which is under way
};

/// A component with cycles, a state table and mailboxes: commands and events that others send wait
/// until its Run() calls ProcessQueuedCommands().
///
/// What makes a cycle due is up to the kinds of tasks, which derive from this class. Tasks with a
/// thread of their own may run after another task instead, in its thread and its cycles.
///
/// What managers ask for is an order; the thread that makes the cycles obeys it between two of
/// them.
class Task : public Component {
 public:
  [[nodiscard]] std::vector<const StateTable*> tables() const override;
  void Seal() override;

  /// The task after which it runs, or null. For managers.
  [[nodiscard]] const Task* leader() const { return leader_.Get(); }
  /// For managers: it runs after nobody any more. kTimeout where the leader's cycle has not ended
  /// by `deadline`; nothing has changed then. It must be at rest.
  Result<void> LeaveLeader(SteadyTime deadline);
  /// How long ago its last cycle began; 0 while it is not active. Any thread.
  [[nodiscard]] std::chrono::nanoseconds SinceLastCycle(SteadyTime now) const noexcept;
  /// What period() was at the last start. Any thread.
  [[nodiscard]] std::chrono::duration<double> started_period() const noexcept {
    return started_period_.Get();
  }

 protected:
  explicit Task(std::string name, Posts posts = Posts::kWait);
  ~Task() override;

  /// The table `state`: variables added to it are recorded once a cycle, after Run().
  StateTable& state_table() { return *tables_.front(); }
  /// A further table, seen by others as the interface `state-NAME`, also recorded once a cycle.
  StateTable& AddStateTable(const std::string& name);

  /// All its tables get a row no sooner after the last; for constructors, before others are added.
  void SetShortestInterval(std::chrono::nanoseconds interval);

  /// One cycle of the author's work, in the task's thread. An exception faults the task. What is
  /// logged here is put aside (CycleLog).
  virtual void Run() = 0;

  /// Executes the commands and events that have arrived, in the calling thread, which is the
  /// task's; how many they were. Called by the author in Run(): when is a control decision.
  std::size_t ProcessQueuedCommands();

  // For kinds of tasks, in the thread that makes the cycles.

  /// Obeys what has been asked of this task and of those that run after it.
  void ObeyOrders();
  /// Whether there is something to obey.
  [[nodiscard]] bool has_orders() const noexcept { return orders_.Get() != orders_seen_; }
  /// Run(), a row of every table, and the cycles of the tasks that run after this one. False once
  /// this one is faulted.
  bool DoCycle(SteadyTime begin, SteadyTime due);
  bool DoCycle(SteadyTime now) { return DoCycle(now, now); }
  /// When the last cycle, with those of the tasks that run after this one, has ended.
  [[nodiscard]] SteadyTime cycle_end() const { return cycle_end_; }
  /// Cycles that were skipped because one took too long, here and in those that run after it.
  void AddOverruns(std::uint64_t cycles);
  /// Ends the tasks that run after this one: for a thread that makes no cycles any more.
  void EndFollowers();
  /// Called when it has become active, at a start as well as after a rest.
  virtual void OnActive() {}

  /// Notified of orders, and of posts where they wake.
  Wakeup<>& wakeup() { return wakeup_; }
  /// The time between two rows, by which tables get their length: about a second of rows.
  [[nodiscard]] virtual std::chrono::nanoseconds row_period() const;

  // For managers.

  /// What a start needs before its order: drops what waited when the task ended.
  void PrepareStart();
  /// Has the thread that makes the cycles obey; where there is none now, this one.
  void GiveOrder(LifeRequest request, bool ends_start = false);
  void Pause() override { GiveOrder(LifeRequest::kSuspend); }
  Result<void> Resume() override;
  void Halt() override { GiveOrder(LifeRequest::kStop, is_starting()); }
  /// From now on it runs after `leader`, and not after its former one. Both must live, and this one
  /// must be at rest. Errors are those of LeaveLeader().
  Result<void> JoinLeader(Task& leader, SteadyTime deadline);

  void FaultFromOutside(const std::string& reason) override;
  void HearOfPeer(RequiredInterface& interface) override;
  void HearOfGoneClient(GoneClient client) override;

 private:
  friend TaskLife;  // the rest of its work, under names that are not in an author's way

  void EndExpiredNow();

  std::shared_ptr<CycleLog> log_;
  std::vector<std::unique_ptr<StateTable>> tables_;
  std::chrono::nanoseconds shortest_interval_{0};
  CycleMeter meter_;
  Wakeup<> wakeup_;
  const char* doing_ = "Run";  // which of the author's functions runs in a cycle
  bool rests_with_leader_ = false;
  SteadyTime cycle_end_{};
  Published<SteadyTime> last_begin_;
  Published<std::chrono::duration<double>> started_period_;

  Published<TaskOrder> order_;
  std::uint32_t obeyed_ = 0;
  Published<std::uint64_t> orders_;  // of all tasks in this thread, and what has failed outside;
                                     // counted in the first of them
  std::uint64_t orders_seen_ = 0;

  Flag has_failed_outside_;
  std::mutex outside_mutex_;  // of the next
  std::string outside_reason_;

  Published<Task*> leader_;
  std::unique_ptr<TaskFollowers> follower_list_;
  std::vector<std::unique_ptr<TaskFollowers>> retired_lists_;  // a cycle may still use them
  GuardedPointer<TaskFollowers> followers_;
};

}  // namespace tendon
