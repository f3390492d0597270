#pragma once

#include <tendon/base/clock.h>

#include <chrono>

namespace tendon {

/// While it lives, calls and events of its thread wait for room in a full mailbox instead of being
/// refused, at most kPatience altogether. For Cleanup(): it is not part of a cycle, and its last
/// command, such as a stop, must get through.
class BlockWhenFull {
 public:
  static constexpr std::chrono::milliseconds kPatience{800};

  BlockWhenFull() noexcept;
  BlockWhenFull(const BlockWhenFull&) = delete;
  BlockWhenFull& operator=(const BlockWhenFull&) = delete;
  ~BlockWhenFull();

  /// The time until which the calling thread waits for room; in the past if it does not wait.
  [[nodiscard]] static SteadyTime deadline() noexcept;

 private:
  const SteadyTime before_;
};

}  // namespace tendon
