#pragma once

#include <functional>
#include <string>
#include <thread>

namespace tendon {

/// Calls `give` every 250 ms in a thread of its own, for at most LargeMessageInProgress::kAtMost,
/// as a sign of life for the peer while the middleware's thread handles a large message. If no
/// thread can be started, only logs that.
class ProgressSender {
 public:
  ProgressSender(const std::string& peer, std::function<void()> give);

 private:
  std::jthread thread_;
};

}  // namespace tendon
