#pragma once

#include <tendon/base/clock.h>

#include <chrono>

namespace tendon {

/// While this object exists, calls and events of its thread wait for room in a full mailbox instead
/// of being refused, at most kMaxWait in total. Used during Cleanup(), because a full mailbox must
/// not refuse its last command, such as a stop. Cleanup() may wait, because the cycles of its
/// component have ended.
class BlockWhenFull {
 public:
  static constexpr std::chrono::milliseconds kMaxWait{800};

  BlockWhenFull() noexcept;
  BlockWhenFull(const BlockWhenFull&) = delete;
  BlockWhenFull& operator=(const BlockWhenFull&) = delete;
  ~BlockWhenFull();

  /// The time until which the calling thread waits for room in a mailbox. A time in the past if the
  /// thread does not wait.
  [[nodiscard]] static SteadyTime deadline() noexcept;

 private:
  const SteadyTime before_;
};

}  // namespace tendon
