#pragma once

#include <tendon/task/task.h>
#include <tendon/task/thread_options.h>

#include <string>
#include <thread>

namespace tendon {

/// A task with its own thread, unless it runs after another task. Derived classes implement Loop().
class ThreadedTask : public Task {
 public:
  /// For managers and constructors: sets the options that the task's thread has from the next start
  /// on. Throws ConfigurationError if a value is out of range or a processor does not exist.
  void SetThreadOptions(const ThreadOptions& options);
  [[nodiscard]] const ThreadOptions& thread_options() const { return options_; }

  /// For managers: from the next start on, the task has no thread, but makes a cycle after each
  /// cycle of `leader`, in the leader's thread. It keeps its own state, tables and statistics. It
  /// can be started and stopped while the leader runs. When the leader is suspended or ends, the
  /// task is suspended or ends too. Fails with kFailed if the task is not at rest, or if the two
  /// tasks would run after each other. Fails with kTimeout if a cycle of the former leader has not
  /// ended by `deadline`; then nothing is changed.
  Result<void> RunAfter(Task& leader, SteadyTime deadline = SteadyTime::max());

  /// The task's own period, or the period of the leader if it has one.
  [[nodiscard]] double period() const final;

 protected:
  using Task::Task;
  ~ThreadedTask() override;

  /// Makes cycles when they are due. Returns when has_orders() is true or a cycle returns false.
  virtual void Loop() = 0;
  /// The options that were applied at the last start.
  [[nodiscard]] const ThreadOptions& options_in_use() const { return options_in_use_; }
  /// The period in seconds if the task has a thread of its own; 0 if there is none.
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
