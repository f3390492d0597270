#pragma once

#include <tendon/base/os/process.h>

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

/// "bin/gcm": where that is in the build this test program lies in. Not told by the compiler:
/// presets share what it makes.
inline std::string Built(const std::string& place) {
  return tendon::os::ProgramFolder().parent_path() / place;
}

/// A program run as a process of its own, as a user would. State, cache and run-time folders are
/// not the user's: the programs of a test share theirs, which go with it. Killed when the object
/// ends.
class Program {
 public:
  using Words = std::vector<std::string>;

  explicit Program(const Words& command,
                   const std::map<std::string, std::string>& environment = {});
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program();

  void Signal(int signal) const;
  /// Its exit code, or 128 + the signal that killed it; nothing when it has not ended in time.
  std::optional<int> Wait(std::chrono::seconds patience = std::chrono::seconds(30));
  /// What it has written so far.
  [[nodiscard]] std::string out() const;
  [[nodiscard]] std::string err() const;
  [[nodiscard]] int pid() const { return pid_; }

 private:
  int pid_ = -1;
  std::optional<int> exit_code_;
  std::string folder_;
};

/// A finished run.
struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Runs a program to its end; exit code -1 when it does not end by itself.
Outcome RunProgram(const Program::Words& command,
                   const std::map<std::string, std::string>& environment = {});

/// A port on 127.0.0.1 that nobody uses, and no other test will be given before this program ends.
int FreePort();
