#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>

namespace tendon::os {

/// Keeps SIGINT and SIGTERM for WaitForTermination(), and lets writes to a closed pipe fail instead
/// of killing the process. First thing in main(), before any thread; again where a program goes on
/// after it was asked.
void HoldTerminationSignals() noexcept;

/// Waits until somebody asks the process to end; returns the signal's number. A second signal then
/// ends the process at once.
int WaitForTermination() noexcept;

/// Whether somebody asks the process to end; waits for at most `patience`. A second signal then
/// ends the process at once.
bool TerminationAsked(std::chrono::milliseconds patience) noexcept;

/// Whether a signal asks for the end of the process, also one that TerminationAsked() or
/// WaitForTermination() has told of, since HoldTerminationSignals().
[[nodiscard]] bool WasTerminationAsked() noexcept;

/// A SIGINT that nobody has asked about does not count any more.
void ForgetInterrupt() noexcept;

/// As long as it lives, SIGINT and SIGTERM end the process at once, also where they are held: for
/// waits that cannot be cut short. On the stack of main()'s thread.
class TerminationLetThrough {
 public:
  TerminationLetThrough() noexcept;
  TerminationLetThrough(const TerminationLetThrough&) = delete;
  TerminationLetThrough& operator=(const TerminationLetThrough&) = delete;
  ~TerminationLetThrough();

 private:
  const bool was_held_;
};

/// Stands for the signals in one thread of a program that has a window: who sits at it ends what
/// that thread does, not the program. As long as it lives, WaitForTermination() and
/// TerminationAsked() in the thread that made it ask it, and nothing there lets signals through.
class Interruption {
 public:
  Interruption() noexcept;
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();

  /// From any thread: asks for the end once.
  void Ask() noexcept;
  /// Whether it was asked for since the last time; waits for at most `patience`.
  bool Take(std::chrono::milliseconds patience) noexcept;
  /// What nobody has asked about does not count any more.
  void Forget() noexcept;

 private:
  std::mutex mutex_;
  std::condition_variable change_;
  bool is_asked_ = false;
};

}  // namespace tendon::os
