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
  std::string path;  ///< path of the component
  std::string state;
  std::string detail;         ///< "waiting for Robot"
  double rate = 0.0;          ///< cycles per second
  double period = 0.0;        ///< s, from the configuration; 0 if it has none
  double late = 0.0;          ///< s; the median lateness
  double latest = 0.0;        ///< s; the maximum lateness
  double compute = 0.0;       ///< s, mean
  double load = 0.0;          ///< fraction of the time during which the task computes
  std::uint64_t skipped = 0;  ///< cycles that were skipped since the start
  std::optional<std::chrono::nanoseconds> age;  ///< for a stopped task: time since its last cycle
  bool is_known = false;    ///< true if the task runs and the values of a whole second have arrived
  bool is_awaited = false;  ///< true if the values of a whole second may arrive soon
};

/// Receives the statistics of all tasks of a system, including tasks that are added later.
class TaskFeed {
 public:
  /// Receives the statistics of all tasks. If `only` is not empty, receives only the statistics of
  /// the component with this path.
  explicit TaskFeed(tendon::GcmClient& client, std::string only = "")
      : client_(client), only_(std::move(only)) {}
  TaskFeed(const TaskFeed&) = delete;
  TaskFeed& operator=(const TaskFeed&) = delete;
  ~TaskFeed();

  /// Returns all tasks in the present catalogue, with their latest figures.
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
