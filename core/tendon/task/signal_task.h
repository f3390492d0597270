#pragma once

#include <tendon/task/threaded_task.h>

#include <string>

namespace tendon {

/// A task that sleeps until a command or an event is queued for it, and then makes a cycle. Its
/// Run() must execute the queued calls with ProcessQueuedCommands(); otherwise the next cycle
/// follows at once. The task also makes a cycle when the effect of a command expires.
class SignalTask : public ThreadedTask {
 protected:
  explicit SignalTask(std::string name);
  ~SignalTask() override;

  void Loop() override;
};

}  // namespace tendon
