#pragma once

#include <tendon/task/thread/threaded_task.h>

#include <string>

namespace tendon {

/// A task that sleeps until a command or an event is queued to it, and then makes a cycle. Its
/// Run() executes what has arrived with ProcessQueuedCommands(); as long as something waits, it is
/// called again. A command that expires wakes it, too.
class SignalTask : public ThreadedTask {
 protected:
  explicit SignalTask(std::string name);
  ~SignalTask() override;

  void Loop() override;
};

}  // namespace tendon
