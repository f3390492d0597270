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
  std::string out;               ///< its standard output, at most 64 KiB
  std::optional<int> exit_code;  ///< empty if a signal ended it
  std::string signal;            ///< for example "SIGSEGV"; empty if no signal ended it
};

/// Runs a program as a separate process and waits until it ends. The program has no input, and its
/// error output is discarded. Errors: kFailed if the program cannot be run, kTimeout if it was
/// killed because it did not end within `timeout`.
Result<ProgramOutcome> RunProgram(const std::filesystem::path& program,
                                  const std::vector<std::string>& arguments,
                                  std::chrono::milliseconds timeout);

/// A program that runs as a separate process and continues when this object, or this process, ends.
/// The program has its own session, so signals of this process's terminal do not reach it. It has
/// no input and inherits no open files of this process. Not thread-safe.
class BackgroundProgram {
 public:
  /// Starts the program. Its output goes to `log`, a new file that only this user can access.
  /// Returns kFailed if the program cannot be run.
  static Result<std::unique_ptr<BackgroundProgram>> Start(const std::filesystem::path& program,
                                                          const std::vector<std::string>& arguments,
                                                          const std::filesystem::path& log);
  BackgroundProgram(const BackgroundProgram&) = delete;
  BackgroundProgram& operator=(const BackgroundProgram&) = delete;

  [[nodiscard]] std::int64_t pid() const noexcept { return pid_; }
  /// Returns the outcome, without output; empty while the program runs.
  std::optional<ProgramOutcome> Ended();
  /// Sends SIGTERM, which asks the program to end.
  void Terminate();
  /// Sends SIGKILL, which ends the program.
  void Kill();

 private:
  explicit BackgroundProgram(std::int64_t pid) : pid_(pid) {}

  void Signal(int signal);

  const std::int64_t pid_;
  std::optional<ProgramOutcome> end_;
};

}  // namespace tendon::os
