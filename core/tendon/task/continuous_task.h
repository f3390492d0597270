#pragma once

#include <tendon/task/threaded_task.h>

#include <string>

namespace tendon {

/// A task that begins its next cycle as soon as the last one has ended. Use it if Run() blocks, for
/// example on a device, or if it should use all available time. By default, its tables get at most
/// one row per millisecond.
class ContinuousTask : public ThreadedTask {
 protected:
  explicit ContinuousTask(std::string name);
  ~ContinuousTask() override;

  void Loop() override;
};

}  // namespace tendon
