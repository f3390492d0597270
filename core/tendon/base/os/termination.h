#pragma once

#include <chrono>

namespace tendon::os {

/// Keeps SIGINT and SIGTERM for WaitForTermination(), and lets writes to a closed pipe fail instead
/// of killing the process. First thing in main(), before any thread.
void HoldTerminationSignals() noexcept;

/// Waits until somebody asks the process to end; returns the signal's number. A second signal then
/// ends the process at once.
int WaitForTermination() noexcept;

/// Whether somebody asks the process to end; waits for at most `patience`.
bool TerminationAsked(std::chrono::milliseconds patience) noexcept;

}  // namespace tendon::os
