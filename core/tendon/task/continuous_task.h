#pragma once

#include <tendon/task/threaded_task.h>

#include <string>

namespace tendon {

/// A task whose next cycle begins when the last one has ended: for a Run() that waits by itself, or
/// that should use all available time. By default, its tables get at most one row per millisecond.
class ContinuousTask : public ThreadedTask {
 protected:
  explicit ContinuousTask(std::string name);
  ~ContinuousTask() override;

  void Loop() override;
};

}  // namespace tendon
