#pragma once

#include <tendon/base/clock.h>

#include <chrono>

namespace tendon {

/// While this object exists, calls and events of its thread wait for room in a full mailbox instead
/// of being refused, at most kPatience in total. Used during Cleanup(), because the last command of
/// Cleanup(), such as a stop, must not be refused. Waiting is allowed there, because Cleanup() is
/// not part of a cycle.
class BlockWhenFull {
 public:
  static constexpr std::chrono::milliseconds kPatience{800};

  BlockWhenFull() noexcept;
  BlockWhenFull(const BlockWhenFull&) = delete;
  BlockWhenFull& operator=(const BlockWhenFull&) = delete;
  ~BlockWhenFull();

  /// The time until which the calling thread waits for room in a mailbox; in the past if it does
  /// not wait.
  [[nodiscard]] static SteadyTime deadline() noexcept;

 private:
  const SteadyTime before_;
};

}  // namespace tendon
