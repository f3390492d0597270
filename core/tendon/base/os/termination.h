#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace tendon::os {

/// Blocks SIGINT and SIGTERM, so that only the functions below receive them, and makes writes to a
/// closed pipe fail instead of killing the process. Call it first in main(), before any thread
/// starts, and again if the program continues after a termination request.
void HoldTerminationSignals() noexcept;

/// Waits until the process is asked to terminate; returns the signal's number. A second signal then
/// ends the process at once.
int WaitForTermination() noexcept;

/// True if the process is asked to terminate; waits for at most `timeout`. A second signal then
/// ends the process at once.
bool TerminationRequested(std::chrono::milliseconds timeout) noexcept;

/// True if a signal has asked the process to terminate since HoldTerminationSignals(), even if
/// TerminationRequested() or WaitForTermination() has already reported it.
[[nodiscard]] bool WasTerminationRequested() noexcept;

/// Discards a pending SIGINT that no function above has reported yet.
void ForgetInterrupt() noexcept;

/// While this object exists, SIGINT and SIGTERM end the process at once, even if they are held. Use
/// it around waits that cannot be interrupted, on the stack of main()'s thread.
class TerminationUnblockScope {
 public:
  TerminationUnblockScope() noexcept;
  TerminationUnblockScope(const TerminationUnblockScope&) = delete;
  TerminationUnblockScope& operator=(const TerminationUnblockScope&) = delete;
  ~TerminationUnblockScope();

 private:
  const bool was_held_;
};

/// Replaces the termination signals for one thread of a GUI program, because its user stops the
/// work of one thread, not the whole program. While this object exists, WaitForTermination() and
/// TerminationRequested() in its thread check this object instead of the signals, and the signals
/// stay blocked.
class Interruption {
 public:
  Interruption() noexcept;
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();

  /// Requests the end of the work. Take() reports the request once. Any thread.
  void Request() noexcept;
  /// True if Request() was called since the last call; waits for at most `timeout`.
  bool Take(std::chrono::milliseconds timeout) noexcept;
  /// Discards a pending request.
  void Forget() noexcept;

 private:
  std::mutex mutex_;
  std::condition_variable change_;
  bool is_requested_ = false;
};

}  // namespace tendon::os
