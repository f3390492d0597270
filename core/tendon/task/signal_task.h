#pragma once

#include <tendon/task/threaded_task.h>

#include <string>

namespace tendon {

/// A task that sleeps until a command or an event is queued to it, and then makes a cycle. Its
/// Run() executes the queued calls with ProcessQueuedCommands(), and is called again while calls
/// are left. The end of an effect that was not renewed also wakes the task.
class SignalTask : public ThreadedTask {
 protected:
  explicit SignalTask(std::string name);
  ~SignalTask() override;

  void Loop() override;
};

}  // namespace tendon
