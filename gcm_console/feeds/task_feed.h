#pragma once

#include <tendon/gcm/client.h>

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace console {

/// The timing of a task in the last whole second.
struct TaskFigures {
  std::string path;  ///< of the component
  std::string state;
  std::string detail;                           ///< "waiting for Robot"
  double rate = 0.0;                            ///< cycles per second
  double period = 0.0;                          ///< s, as configured; 0 if it has none
  double late = 0.0;                            ///< s; the median lateness
  double latest = 0.0;                          ///< s; the maximum lateness
  double compute = 0.0;                         ///< s, mean
  double load = 0.0;                            ///< the fraction of the time in which it computes
  std::uint64_t skipped = 0;                    ///< cycles since its start
  std::optional<std::chrono::nanoseconds> age;  ///< since the last cycle of a stopped task
  bool is_known = false;    ///< true if the task runs and a whole second was received
  bool is_awaited = false;  ///< true if a whole second may be received soon
};

/// Receives the statistics of all tasks of a system, including tasks that are added later.
class TaskFeed {
 public:
  /// All tasks, or only the component at the path `only`.
  explicit TaskFeed(tendon::GcmClient& client, std::string only = "")
      : client_(client), only_(std::move(only)) {}
  TaskFeed(const TaskFeed&) = delete;
  TaskFeed& operator=(const TaskFeed&) = delete;
  ~TaskFeed();

  /// All tasks in the present catalogue, with their latest figures.
  std::vector<TaskFigures> Look();

 private:
  class Listener;
  struct Entry {
    tendon::TelemetryClient::Id id = 0;
    std::shared_ptr<Listener> listener;
  };

  tendon::GcmClient& client_;
  const std::string only_;
  std::map<std::string, Entry> entries_;  // by path
};

}  // namespace console
