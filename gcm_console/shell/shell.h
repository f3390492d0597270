#pragma once

#include <gcm_console/command_line/shell_session.h>
#include <gcm_console/completion/completer.h>
#include <gcm_console/completion/live_completion.h>
#include <gcm_console/console.h>
#include <gcm_console/shell/command_parser.h>
#include <gcm_console/shell/jobs.h>
#include <tendon/gcm/system/plan_execution.h>

#include <optional>
#include <string>
#include <vector>

namespace console {

/// Runs lines of text as commands of `gcm`, for `gcm shell`, `gcm run` and the console of the
/// window. The lines need not begin with `gcm`. Relative paths are relative to the path of the last
/// `cd`. For one thread.
class Shell {
 public:
  explicit Shell(Settings settings);

  /// Runs the commands of one line. After a command has failed, kStop does not run the rest of the
  /// line. Returns the exit code of the first command that has failed; 0 if none has failed.
  int Run(const std::string& line, const Streams& streams, tendon::AfterError after_error);
  /// True after the command `exit`.
  [[nodiscard]] bool has_ended() const { return has_ended_; }

  /// Returns the prompt with the path to which relative paths are relative: "robot/arm> ".
  [[nodiscard]] std::string prompt() const;
  /// Returns the completions of a line, from the catalogue as known now. Waits at most 100 ms, and
  /// only for the first reply of a process: some words, such as names of parameters, are known
  /// only to the process.
  [[nodiscard]] WordCompletion Complete(const PartialCommand& line);
  /// Returns the complete lines that background jobs have written since the last call; empty if
  /// there are no jobs.
  std::optional<std::string> TakeLines() { return jobs_.TakeLines(); }

 private:
  int RunCommand(const ShellCommand& command, const Streams& streams);
  /// Runs a command of the shell itself. Returns no value if `words` is not such a command.
  std::optional<tendon::Result<void>> RunOwnWord(const Words& words, const Streams& streams);
  tendon::Result<void> BeginInBackground(const Words& words, const Streams& streams);
  std::vector<std::string> LiveCompletionsOf(WordKind kind, const Words& before);
  tendon::Result<void> GoTo(const std::string& typed);

  ShellSession session_;
  const Page page_;
  LiveCompletion live_completion_;
  Jobs jobs_;
  bool has_ended_ = false;
};

}  // namespace console
