#pragma once

#include <tendon/task/thread_options.h>

#include <string>

namespace tendon {

/// Throws ConfigurationError, naming `task` and the option, if a value is invalid on every machine.
void CheckThreadRanges(const ThreadOptions& options, const std::string& task);

/// The same, and also checks what is valid only on some machines.
void CheckThreadOptions(const ThreadOptions& options, const std::string& task);

/// Gives the calling thread the name of `task` and applies all options except `spin`.
void SetUpThisThread(const ThreadOptions& options, const std::string& task);

}  // namespace tendon
