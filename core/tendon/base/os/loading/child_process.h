#pragma once

#include <tendon/base/result.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
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

/// A program that runs as a process of its own and goes on when this object, or this process, ends.
/// It has a session of its own, so that what a terminal sends to us does not reach it; no input,
/// and none of our files. Not thread-safe.
class BackgroundProgram {
 public:
  /// What it writes goes to `log`, a new file of this user alone. kFailed where it cannot be run.
  static Result<std::unique_ptr<BackgroundProgram>> Start(const std::filesystem::path& program,
                                                          const std::vector<std::string>& arguments,
                                                          const std::filesystem::path& log);
  BackgroundProgram(const BackgroundProgram&) = delete;
  BackgroundProgram& operator=(const BackgroundProgram&) = delete;

  [[nodiscard]] std::int64_t pid() const noexcept { return pid_; }
  /// How it ended; nothing as long as it runs. Without output.
  std::optional<ProgramOutcome> Ended();
  /// Asks it to end: SIGTERM.
  void Terminate();
  /// Ends it: SIGKILL.
  void Kill();

 private:
  explicit BackgroundProgram(std::int64_t pid) : pid_(pid) {}

  void Signal(int signal);

  const std::int64_t pid_;
  std::optional<ProgramOutcome> end_;
};

}  // namespace tendon::os
