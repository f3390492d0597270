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

/// How a task has kept its time in the last whole second.
struct TaskFigures {
  std::string path;  ///< of the component
  std::string state;
  std::string detail;                           ///< "waiting for Robot"
  double rate = 0.0;                            ///< cycles a second
  double period = 0.0;                          ///< s, as wanted; 0 where it has none
  double late = 0.0;                            ///< s: half of the cycles began no later than that
  double latest = 0.0;                          ///< s
  double compute = 0.0;                         ///< s, mean
  double load = 0.0;                            ///< part of the time that it computes
  std::uint64_t skipped = 0;                    ///< cycles, since its start
  std::optional<std::chrono::nanoseconds> age;  ///< since its last cycle, of one that stands still
  bool is_known = false;    ///< whether a second has been heard of, and the task runs
  bool is_awaited = false;  ///< whether one may be heard of soon
};

/// Listens to the tasks of a system, which come and go.
class TaskFeed {
 public:
  /// Of all, or of the one at a path.
  explicit TaskFeed(tendon::GcmClient& client, std::string only = "")
      : client_(client), only_(std::move(only)) {}
  TaskFeed(const TaskFeed&) = delete;
  TaskFeed& operator=(const TaskFeed&) = delete;
  ~TaskFeed();

  /// All tasks that the catalogue has now, with what was heard of them.
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
