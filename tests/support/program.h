#pragma once

#include <tendon/base/os/process.h>

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "support/machine/sanitized.h"

/// Returns the path of a file such as "bin/gcm" in the build folder of this test program. The
/// folder is found at run time, because presets share compiled objects.
inline std::string Built(const std::string& place) {
  return tendon::os::ProgramFolder().parent_path() / place;
}

/// A program that runs as a separate process. Its state, cache and run-time folders are not the
/// user's: all programs of a test share temporary folders. The destructor kills the program.
class Program {
 public:
  using Words = std::vector<std::string>;

  explicit Program(const Words& command,
                   const std::map<std::string, std::string>& environment = {});
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program();

  void Signal(int signal) const;
  /// Waits for the end. Returns the exit code, or 128 + the number of the signal that killed the
  /// program; empty if the program has not ended in time.
  std::optional<int> Wait(std::chrono::seconds timeout = tendon::test::LongestWait());
  /// Returns the output so far.
  [[nodiscard]] std::string out() const;
  [[nodiscard]] std::string err() const;
  [[nodiscard]] int pid() const { return pid_; }

 private:
  int pid_ = -1;
  std::optional<int> exit_code_;
  std::string folder_;
};

/// The result of a finished run.
struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Runs a program to its end. The exit code is -1 if the program does not end by itself.
Outcome RunProgram(const Program::Words& command,
                   const std::map<std::string, std::string>& environment = {});

/// Returns an unused port on 127.0.0.1. No other test gets this port before this program ends.
int FreePort();
