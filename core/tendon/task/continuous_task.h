#pragma once

#include <tendon/task/thread/threaded_task.h>

#include <string>

namespace tendon {

/// A task whose next cycle begins when the last has ended: for a Run() that waits for something
/// itself, or that never has enough time. Its tables get a row at most once a millisecond, unless
/// they are told otherwise.
class ContinuousTask : public ThreadedTask {
 protected:
  explicit ContinuousTask(std::string name);
  ~ContinuousTask() override;

  void Loop() override;
};

}  // namespace tendon
