#pragma once

#include <tendon/task/task.h>
#include <tendon/task/thread_options.h>

#include <string>
#include <thread>

namespace tendon {

/// A task with a thread of its own, unless it runs after another one. Kinds of it implement Loop().
class ThreadedTask : public Task {
 public:
  /// For managers and constructors: how its thread runs from the next start on. ConfigurationError
  /// where an option is out of range, or names a processor that is not there.
  void SetThreadOptions(const ThreadOptions& options);
  [[nodiscard]] const ThreadOptions& thread_options() const { return options_; }

  /// For managers: from the next start on it has no thread, but makes a cycle after each one of
  /// `leader`, in that one's thread. It keeps its state, its tables and its statistics, and starts
  /// and stops by itself while the leader runs; the leader's rest and end are its own. kFailed
  /// where it is not at rest, or where the two would wait for each other; kTimeout where a cycle of
  /// its former leader has not ended by `deadline`: nothing has changed then.
  Result<void> RunAfter(Task& leader, SteadyTime deadline = SteadyTime::max());

  /// That of the leader if it has one.
  [[nodiscard]] double period() const final;

 protected:
  using Task::Task;
  ~ThreadedTask() override;

  /// Makes cycles when they are due, until has_orders(), or until one returns false.
  virtual void Loop() = 0;
  /// As they were at the start.
  [[nodiscard]] const ThreadOptions& options_in_use() const { return options_in_use_; }
  /// s, in a thread of its own; 0 where its cycles have no period.
  [[nodiscard]] virtual double own_period() const { return 0.0; }

  Result<void> Launch() override;

  /// Ends the thread; to be called by the destructor of every class that implements Loop(), for a
  /// thread must not outlive what it runs.
  void Join();

  /// What its thread runs.
  void MakeCycles();

 private:
  ThreadOptions options_;
  ThreadOptions options_in_use_;
  std::thread thread_;
};

}  // namespace tendon
