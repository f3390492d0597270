#pragma once

#include <tendon/base/clock.h>
#include <tendon/base/log.h>

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace tendon {

class Component;
class Task;

/// Detects periodic tasks whose cycle blocks. A task is overdue if no cycle has begun for three
/// periods plus 50 ms. The watchdog logs when a task becomes overdue, and when the task continues.
/// It ignores tasks without a period.
///
/// One thread checks all tasks every 50 ms. It is started when the first task is added.
/// Thread-safe.
class Watchdog {
 public:
  static constexpr std::chrono::milliseconds kBetweenLooks{50};
  static constexpr std::chrono::milliseconds kGrace{50};
  static constexpr int kPeriods = 3;

  /// `on_change` is called, in the watchdog's thread, when a warning appears or disappears.
  explicit Watchdog(std::function<void()> on_change) : on_change_(std::move(on_change)) {}
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;
  ~Watchdog();

  /// Begins to check a task. Forget() must be called before `task` is destroyed.
  void Watch(const Task& task);
  void Forget(const Component& component);

  /// Returns "missed 8 x 10 ms" while the task is overdue, otherwise an empty text.
  [[nodiscard]] std::string WarningOf(const Component& component) const;

  /// Returns true if a task with this period is overdue. `since_last_cycle` is the time since its
  /// last cycle began.
  [[nodiscard]] static bool IsOverdue(std::chrono::duration<double> period,
                                      std::chrono::nanoseconds since_last_cycle);

 private:
  struct WatchedTask {
    const Task* task;
    std::string warning;
    SteadyTime since{};  // the time when its last cycle began
  };

  struct Finding {
    std::string task;
    LogLevel level;
    std::string text;
  };

  static void Check(WatchedTask& watched, SteadyTime now, std::vector<Finding>& findings);
  void Inspect(SteadyTime now);
  void Run();

  std::function<void()> on_change_;
  mutable std::mutex mutex_;
  std::condition_variable stopped_;
  bool stopping_ = false;
  std::vector<WatchedTask> tasks_;
  std::thread thread_;
};

}  // namespace tendon
