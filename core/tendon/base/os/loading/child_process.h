#pragma once

#include <tendon/base/result.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tendon::os {

/// How a program ended.
struct ProgramOutcome {
  std::string out;               ///< what it wrote to its standard output, at most 64 KiB
  std::optional<int> exit_code;  ///< nothing where a signal ended it
  std::string signal;            ///< "SIGSEGV"; "" where it ended by itself
};

/// Runs a program as a process of its own, without input, its errors thrown away, and waits for its
/// end. Errors: kFailed where it cannot be run, kTimeout where it had to be killed.
Result<ProgramOutcome> RunProgram(const std::filesystem::path& program,
                                  const std::vector<std::string>& arguments,
                                  std::chrono::milliseconds patience);

}  // namespace tendon::os
