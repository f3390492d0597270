#pragma once

#include <tendon/task/thread/threaded_task.h>

#include <string>

namespace tendon {

/// A task whose next cycle begins when the last one has ended: for a Run() that waits by itself, or
/// that needs all the time it can get. Its tables get a row at most once a millisecond, unless set
/// otherwise.
class ContinuousTask : public ThreadedTask {
 protected:
  explicit ContinuousTask(std::string name);
  ~ContinuousTask() override;

  void Loop() override;
};

}  // namespace tendon
