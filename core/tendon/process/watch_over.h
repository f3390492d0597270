#pragma once

#include <tendon/middleware/channel.h>
#include <tendon/process/worker.h>

#include <memory>

namespace tendon {

/// Asks the process at the other end twice a second whether it lives, as long as the channel is
/// open, and closes the channel when there was no answer for 1.5 s: a process that hangs, or has
/// been cut off, does not close it. `worker` sees to the time.
void WatchOver(const std::shared_ptr<Worker>& worker, const std::shared_ptr<Channel>& channel);

}  // namespace tendon
