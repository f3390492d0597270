#pragma once

#include <tendon/base/clock.h>

#include <chrono>

namespace tendon {

/// While it lives, calls and events of its thread that find a mailbox full wait for room instead of
/// being refused, all together no longer than kPatience: for Cleanup(), which is no part of a cycle
/// and whose last command, such as a stop, must get through.
class PatientCalls {
 public:
  static constexpr std::chrono::milliseconds kPatience{800};

  PatientCalls() noexcept;
  PatientCalls(const PatientCalls&) = delete;
  PatientCalls& operator=(const PatientCalls&) = delete;
  ~PatientCalls();

  /// Until when the calling thread waits for room; the past where it does not.
  [[nodiscard]] static SteadyTime deadline() noexcept;

 private:
  const SteadyTime before_;
};

}  // namespace tendon
