#pragma once

#include <tendon/task/thread_options.h>

#include <string>

namespace tendon {

/// ConfigurationError that names `task` and the option, where one makes no sense on any machine.
void CheckThreadRanges(const ThreadOptions& options, const std::string& task);

/// The same, and where one makes no sense on this machine.
void CheckThreadOptions(const ThreadOptions& options, const std::string& task);

/// Makes the calling thread that of `task`: its name and all options but the spinning.
void SetUpThisThread(const ThreadOptions& options, const std::string& task);

}  // namespace tendon
