#pragma once

#include <chrono>

namespace tendon::os {

/// Keeps SIGINT and SIGTERM for WaitForTermination(), and lets writes to a closed pipe fail instead
/// of killing the process. First thing in main(), before any thread.
void HoldTerminationSignals() noexcept;

/// Waits until somebody asks the process to end; returns the signal's number. A second signal then
/// ends the process at once.
int WaitForTermination() noexcept;

/// Whether somebody asks the process to end; waits for at most `patience`. A second signal then
/// ends the process at once.
bool TerminationAsked(std::chrono::milliseconds patience) noexcept;

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

}  // namespace tendon::os
