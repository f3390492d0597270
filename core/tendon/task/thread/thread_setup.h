#pragma once

#include <tendon/task/thread_options.h>

#include <string>

namespace tendon {

/// Throws ConfigurationError, naming `task` and the option, if a value is invalid everywhere.
void CheckThreadRanges(const ThreadOptions& options, const std::string& task);

/// The same, and if a value is invalid on this machine.
void CheckThreadOptions(const ThreadOptions& options, const std::string& task);

/// Gives the calling thread the name of `task` and all options except the spinning.
void SetUpThisThread(const ThreadOptions& options, const std::string& task);

}  // namespace tendon
