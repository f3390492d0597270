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

/// Detects periodic tasks whose cycle blocks: a task is overdue if no cycle began for three periods
/// and 50 ms. Logs this once, and once more when the task continues. Tasks without a period are
/// ignored.
///
/// One thread checks all tasks every 50 ms; it starts with the first task. Thread-safe.
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

  /// Call Forget() before `task` is destroyed.
  void Watch(const Task& task);
  void Forget(const Component& component);

  /// "missed 8 x 10 ms" while the task is overdue, else empty.
  [[nodiscard]] std::string WarningOf(const Component& component) const;

  /// True if a task with this period is overdue, given the time since its last cycle began.
  [[nodiscard]] static bool IsOverdue(std::chrono::duration<double> period,
                                      std::chrono::nanoseconds since_last_cycle);

 private:
  struct Watched {
    const Task* task;
    std::string warning;
    SteadyTime since{};  // when its last cycle began
  };

  struct Finding {
    std::string task;
    LogLevel level;
    std::string text;
  };

  static void Check(Watched& watched, SteadyTime now, std::vector<Finding>& findings);
  void Inspect(SteadyTime now);
  void Run();

  std::function<void()> on_change_;
  mutable std::mutex mutex_;
  std::condition_variable stopped_;
  bool stopping_ = false;
  std::vector<Watched> tasks_;
  std::thread thread_;
};

}  // namespace tendon
