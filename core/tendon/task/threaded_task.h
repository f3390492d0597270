#pragma once

#include <tendon/task/task.h>
#include <tendon/task/thread_options.h>

#include <string>
#include <thread>

namespace tendon {

/// A task with its own thread, unless it runs after another task. Derived classes implement Loop().
class ThreadedTask : public Task {
 public:
  /// Sets the options of the task's thread, which apply from the next start on. Throws
  /// ConfigurationError if a value is out of range or a processor does not exist. For managers and
  /// constructors.
  void SetThreadOptions(const ThreadOptions& options);
  [[nodiscard]] const ThreadOptions& thread_options() const { return options_; }

  /// Makes the task run after `leader` from the next start on: it has no thread, but makes a cycle
  /// after each cycle of `leader`, in the leader's thread. For managers.
  ///
  /// The task keeps its own state, tables and statistics, and can be started and stopped while the
  /// leader runs. When the leader is suspended or ends, the task is suspended or ends, too.
  ///
  /// Fails with kFailed if the task is not at rest, or if the two tasks would run after each other.
  /// Fails with kTimeout, and changes nothing, if a cycle of the former leader has not ended by
  /// `deadline`.
  Result<void> RunAfter(Task& leader, SteadyTime deadline = SteadyTime::max());

  /// Returns the task's own period, or the leader's period if the task has a leader.
  [[nodiscard]] double period() const final;

 protected:
  using Task::Task;
  ~ThreadedTask() override;

  /// Makes cycles when they are due. Returns when has_orders() is true or a cycle returns false.
  virtual void Loop() = 0;
  /// The options that were applied at the last start.
  [[nodiscard]] const ThreadOptions& options_in_use() const { return options_in_use_; }
  /// Returns the period in seconds with which the task's own thread makes cycles; 0 without a
  /// period.
  [[nodiscard]] virtual double own_period() const { return 0.0; }

  Result<void> Launch() override;

  /// Ends the thread. The destructor of every class that implements Loop() must call it, because a
  /// thread must not outlive the code that it runs.
  void Join();

  /// The main function of the thread.
  void MakeCycles();

 private:
  ThreadOptions options_;
  ThreadOptions options_in_use_;
  std::thread thread_;
};

}  // namespace tendon
