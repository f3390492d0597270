#pragma once

#include <tendon/task/thread_options.h>

#include <string>

namespace tendon {

/// Throws a ConfigurationError that names `task` and the option if a value is invalid on any
/// machine.
void CheckThreadRanges(const ThreadOptions& options, const std::string& task);

/// Like CheckThreadRanges(), but also checks that the values are valid on this machine.
void CheckThreadOptions(const ThreadOptions& options, const std::string& task);

/// Gives the calling thread the name of `task` and applies all options except `spin`.
void SetUpThisThread(const ThreadOptions& options, const std::string& task);

}  // namespace tendon
