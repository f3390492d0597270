#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace tendon::os {

/// Keeps SIGINT and SIGTERM for WaitForTermination(), and makes writes to a closed pipe fail
/// instead of killing the process. Call it first in main(), before any thread starts, and again if
/// the program goes on after a request to end.
void HoldTerminationSignals() noexcept;

/// Waits until the process is asked to end; returns the signal's number. A second signal then ends
/// the process at once.
int WaitForTermination() noexcept;

/// True if the process is asked to end; waits for at most `patience`. A second signal then ends the
/// process at once.
bool TerminationAsked(std::chrono::milliseconds patience) noexcept;

/// True if a signal has asked the process to end since HoldTerminationSignals(), even if
/// TerminationAsked() or WaitForTermination() has already told so.
[[nodiscard]] bool WasTerminationAsked() noexcept;

/// Discards a SIGINT that was not asked for yet.
void ForgetInterrupt() noexcept;

/// While it lives, SIGINT and SIGTERM end the process at once, even if they are held: for waits
/// that cannot be cut short. On the stack of main()'s thread.
class TerminationUnblockScope {
 public:
  TerminationUnblockScope() noexcept;
  TerminationUnblockScope(const TerminationUnblockScope&) = delete;
  TerminationUnblockScope& operator=(const TerminationUnblockScope&) = delete;
  ~TerminationUnblockScope();

 private:
  const bool was_held_;
};

/// Replaces the signals in one thread of a program with a window: its user ends the work of that
/// thread, not the program. While it lives, WaitForTermination() and TerminationAsked() in the
/// thread that made it ask this object, and nothing there lets signals through.
class Interruption {
 public:
  Interruption() noexcept;
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();

  /// From any thread: asks for the end once.
  void Ask() noexcept;
  /// True if it was asked for since the last call; waits for at most `patience`.
  bool Take(std::chrono::milliseconds patience) noexcept;
  /// Discards a request that was not taken yet.
  void Forget() noexcept;

 private:
  std::mutex mutex_;
  std::condition_variable change_;
  bool is_asked_ = false;
};

}  // namespace tendon::os
