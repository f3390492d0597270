#pragma once

#include <functional>
#include <string>
#include <thread>

namespace tendon {

/// While it lives, calls a function every 250 ms, in a thread of its own, for LargeInHand::kAtMost:
/// for the peer of a thread that handles something large and hears nothing meanwhile. Where no
/// thread can be had, no sign is given, and that is logged.
class RepeatedSign {
 public:
  RepeatedSign(const std::string& peer, std::function<void()> give);

 private:
  std::jthread thread_;
};

}  // namespace tendon
